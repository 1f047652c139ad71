// A small window from which a file can be dragged: for the test that drops one on the window of Flying Polygons.
//
//   drag_source FILE

#include <gtk/gtk.h>

namespace {

GdkContentProvider* file_of(GtkDragSource*, double, double, gpointer path)
{
    GFile* file = g_file_new_for_path(static_cast<const char*>(path));
    GdkContentProvider* provider = gdk_content_provider_new_typed(G_TYPE_FILE, file);
    g_object_unref(file);
    return provider;
}

void show(GtkApplication* application, gpointer path)
{
    GtkWidget* window = gtk_application_window_new(application);
    gtk_window_set_title(GTK_WINDOW(window), "a file to drag");
    gtk_window_set_default_size(GTK_WINDOW(window), 120, 60);
    GtkWidget* label = gtk_label_new("a file");
    GtkDragSource* source = gtk_drag_source_new();
    g_signal_connect(source, "prepare", G_CALLBACK(file_of), path);
    gtk_widget_add_controller(label, GTK_EVENT_CONTROLLER(source));
    gtk_window_set_child(GTK_WINDOW(window), label);
    gtk_window_present(GTK_WINDOW(window));
}

} // namespace

int main(int count, char** words)
{
    if (count != 2) return 2;
    GtkApplication* application = gtk_application_new(nullptr, G_APPLICATION_NON_UNIQUE);
    g_signal_connect(application, "activate", G_CALLBACK(show), words[1]);
    const int status = g_application_run(G_APPLICATION(application), 0, nullptr);
    g_object_unref(application);
    return status;
}
