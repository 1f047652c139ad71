// The main window and files: opening, saving, dialogs.

#include <fmt/format.h>
#include <giomm/file.h>
#include <gtkmm/dialog.h>
#include <gtkmm/filefilter.h>

#include <filesystem>

#include "play/seconds.hpp"
#include "play/state.hpp"
#include "scene/fault.hpp"
#include "scene/generate.hpp"
#include "scene/read.hpp"
#include "scene/write.hpp"
#include "window/main_window.hpp"

namespace flying {

void MainWindow::answer_requests()
{
    while (!stage_.requests.empty()) {
        const std::vector<Request> requests = std::exchange(stage_.requests, {});
        for (const Request request : requests) answer(request);
    }
}

void MainWindow::answer(Request request)
{
    const std::string stem = std::filesystem::path(options_.scene).stem().string();
    switch (request) {
    case Request::quit:
        close();
        break;
    case Request::panel:
        panel_.set_visible(!panel_.get_visible());
        if (!panel_.get_visible()) canvas_.grab_focus();
        break;
    case Request::fullscreen:
        if (is_fullscreen()) unfullscreen();
        else fullscreen();
        break;
    case Request::open:
        ask_for_file("Open a scene", Gtk::FileChooser::Action::OPEN, "*.toml",
                     [this](const std::string& path) { open_path(path); });
        break;
    case Request::face:
        ask_for_file("A picture for the balls", Gtk::FileChooser::Action::OPEN, "*.png",
                     [this](const std::string& path) { load_face(path); });
        break;
    case Request::save:
        ask_for_file("Save the scene", Gtk::FileChooser::Action::SAVE, "*.toml",
                     [this](const std::string& path) { save_scene(path); });
        break;
    case Request::video:
        report(recorder_.toggle_video(free_name(stem, ".mp4"), stage_.size));
        break;
    case Request::trace:
        report(recorder_.toggle_trace(free_name(stem, ".ndjson")));
        break;
    case Request::state: {
        const std::string path = options_.state.empty() ? free_name(stem + "-state", ".json") : options_.state;
        const std::string more = fmt::format("\"scene\":{},\n\"film\":{},\n\"controls\":{}", json_text(options_.scene),
                                             recorder_.frames(), panel_.places(*this));
        const std::optional<Fault> fault = write_whole(path, state_json(stage_, more));
        // Where the file was given, looking changes nothing of what is looked at
        if (fault) stage_.say(format_fault(*fault), true);
        else if (options_.state.empty()) stage_.say("State written to " + path);
        break;
    }
    }
}

void MainWindow::report(const Expected<std::string>& outcome)
{
    if (outcome) stage_.say(outcome.value());
    else stage_.say(format_fault(outcome.faults().front()), true);
}

void MainWindow::ask_for_file(const char* title, Gtk::FileChooser::Action action, const char* pattern,
                              std::function<void(const std::string&)> act)
{
    // Kept once it is made: GTK 4.8 goes on reading a folder for a dialog that is gone, and tells it when it has done
    // so
    Glib::RefPtr<Gtk::FileChooserNative>& chooser = choosers_[title];
    const bool saves = action == Gtk::FileChooser::Action::SAVE;
    if (!chooser) {
        chooser = Gtk::FileChooserNative::create(title, *this, action, saves ? "Save" : "Open", "Cancel");
        chooser->set_modal(true);
        auto filter = Gtk::FileFilter::create();
        filter->set_name(pattern);
        filter->add_pattern(pattern);
        chooser->add_filter(filter);
        chooser->signal_response().connect([this, asked = chooser.get(), act = std::move(act)](int response) {
            const auto file = asked->get_file();
            if (response == static_cast<int>(Gtk::ResponseType::ACCEPT) && file) act(file->get_path());
            touch();
        });
    }
    if (saves) {
        chooser->set_current_name(
            free_name(std::filesystem::path(options_.scene).stem().string() + "-played", ".toml"));
    }
    chooser->show();
}

void MainWindow::choose_scene(int index)
{
    const int scenes = static_cast<int>(options_.scenes.size());
    if (index < scenes) {
        open_path(options_.scenes[static_cast<std::size_t>(index)]);
        return;
    }
    const std::vector<GeneratorKind>& kinds = generator_kinds();
    const int kind = index - scenes;
    if (kind < 0 || kind >= static_cast<int>(kinds.size())) return;
    GenerateOptions options;
    options.seed = 1 + static_cast<std::uint64_t>(1e3 * seconds_now()) % 1000000;
    const std::string& name = kinds[static_cast<std::size_t>(kind)].name;
    play_scene(generate(name, options), name, fmt::format("{}, seed {}", name, options.seed));
}

void MainWindow::open_path(const std::string& path)
{
    if (path.ends_with(".png") || path.ends_with(".PNG")) load_face(path);
    else play_scene(read_scene_file(path), path, std::filesystem::path(path).stem().string());
}

void MainWindow::play_scene(Expected<Scene> scene, const std::string& name, const std::string& words)
{
    Faults faults;
    if (scene) {
        Expected<Stage> opened = Stage::open(std::move(scene).value());
        if (opened) {
            Stage fresh = std::move(opened).value();
            fresh.look = stage_.look;
            fresh.face = stage_.face;
            fresh.box_follows = stage_.box_follows;
            fresh.clock.speed = stage_.clock.speed;
            fresh.size = stage_.size;
            stage_ = std::move(fresh);
            options_.scene = name;
            scene_words_ = words;
            set_title("Flying Polygons: " + name);
            const Scene& played = stage_.run.scene();
            stage_.say((played.title.empty() ? name : played.title) +
                       (played.bodies.empty() ? ": no bodies yet; 2, 3 and 4 add some" : ""));
        } else {
            faults = opened.faults();
        }
    } else {
        faults = scene.faults();
    }
    if (!faults.empty()) {
        const std::string more = faults.size() > 1 ? fmt::format(" (and {} faults more)", faults.size() - 1) : "";
        stage_.say(format_fault(faults.front()) + more, true);
    }
    panel_.show_scene(options_.scene, scene_words_);
    touch();
}

void MainWindow::load_face(const std::string& path)
{
    std::shared_ptr<cairo_surface_t> face(cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy);
    const cairo_status_t status = cairo_surface_status(face.get());
    if (status != CAIRO_STATUS_SUCCESS) {
        stage_.say(fmt::format("{}: {}; expected a PNG", path, cairo_status_to_string(status)), true);
    } else {
        stage_.face = std::move(face);
        stage_.say("Faces from " + path);
    }
    touch();
}

void MainWindow::save_scene(const std::string& path)
{
    Scene scene = stage_.run.scene_now();
    const std::string comment = fmt::format("Played to {:g} s", stage_.run.time());
    const std::optional<Fault> fault = write_whole(path, write_scene(scene, comment));
    stage_.say(fault ? format_fault(*fault) : "Saved to " + path, fault.has_value());
}

} // namespace flying
