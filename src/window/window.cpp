#include "window/window.hpp"

#include <gtk/gtk.h>
#include <gdkmm/display.h>
#include <gtkmm/application.h>
#include <gtkmm/cssprovider.h>
#include <gtkmm/stylecontext.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "window/main_window.hpp"

namespace flying {

int run_window(Stage stage, const WindowOptions& options)
{
    // All that changes in a frame is one picture: what the graphics card could do with it isn't worth starting it up
    setenv("GSK_RENDERER", "cairo", 0);
    if (!gtk_init_check()) {
        std::fputs("flying: no display to open a window on; flying simulate SCENE --picture FILE.png or --video FILE.mp4 "
                   "need none\n",
                   stderr);
        return 1;
    }
    const auto application = Gtk::Application::create("org.flying.polygons", Gio::Application::Flags::NON_UNIQUE);
    std::unique_ptr<MainWindow> window;
    application->signal_activate().connect([&] {
        // Controls close together, so that all are seen in a window of 800 pixels
        const auto style = Gtk::CssProvider::create();
        style->load_from_data("button { padding: 1px 8px; min-height: 22px; } scale { padding: 4px 8px; min-height: 16px; }"
                              " scale.horizontal > value.right { margin-left: 16px; }"
                              " checkbutton { padding: 0 2px; min-height: 20px; }");
        Gtk::StyleContext::add_provider_for_display(Gdk::Display::get_default(), style, GTK_STYLE_PROVIDER_PRIORITY_APPLICATION);
        window = std::make_unique<MainWindow>(stage, options);
        application->add_window(*window);
        window->present();
    });
    const int status = application->run();
    window.reset();
    return status;
}

} // namespace flying
