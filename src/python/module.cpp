#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/eval.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "python/scene_text.hpp"
#include "scene/fault.hpp"
#include "scene/generate_words.hpp"
#include "scene/read.hpp"
#include "scene/write.hpp"
#include "world/event_share.hpp"
#include "world/make_room.hpp"
#include "world/world.hpp"
#include "json/report_json.hpp"
#include "json/saved_run.hpp"

// The module `flying` of Python: scenes as TOML text or dicts, states as NumPy arrays, reports as dicts. docs/USING.md.

namespace py = pybind11;

namespace flying {

namespace {

// ---- What goes wrong ------------------------------------------------------------------------------------------------

py::list fault_list(const Faults& faults)
{
    py::list list;
    for (const Fault& fault : faults) {
        py::dict entry;
        entry["place"] = fault.place;
        entry["found"] = fault.found;
        entry["expected"] = fault.expected;
        list.append(entry);
    }
    return list;
}

[[noreturn]] void raise(py::object error)
{
    PyErr_SetObject(py::type::handle_of(error).ptr(), error.ptr());
    throw py::error_already_set();
}

py::object error_class(const char* name)
{
    return py::module_::import("flying").attr(name);
}

[[noreturn]] void raise_faults(const Faults& faults)
{
    std::string text = format_faults(faults);
    if (text.ends_with('\n')) text.pop_back();
    py::object error = error_class("SceneError")(text);
    error.attr("faults") = fault_list(faults);
    raise(error);
}

[[noreturn]] void raise_failure(const RunFailure& failure)
{
    py::object error = error_class("RunError")(failure.message);
    error.attr("time") = failure.time;
    error.attr("bodies") = failure.bodies;
    raise(error);
}

template <typename T>
T value_or_raise(Expected<T> expected)
{
    if (!expected) raise_faults(expected.faults());
    return std::move(expected).value();
}

// ---- A world --------------------------------------------------------------------------------------------------------

Scene read_scene(const py::object& scene)
{
    return value_or_raise(read_scene_text(scene_text(scene), "scene", make_room_for_digits));
}

WorldOptions make_options(const std::string& engine, double step, const std::vector<std::string>& without)
{
    WorldOptions options;
    if (engine == "events") options.engine = EngineChoice::events;
    else if (engine == "rest") options.engine = EngineChoice::rest;
    else if (engine != "auto") raise_faults({{"engine", "\"" + engine + "\"", "\"auto\", \"events\" or \"rest\""}});
    const std::vector<std::string> known = skip_names();
    for (const std::string& name : without) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        std::string names;
        for (const std::string& one : known) names += (names.empty() ? "" : ", ") + one;
        raise_faults({{"without", "\"" + name + "\"", "one of " + names}});
    }
    options.without = without;
    options.step = step;
    return options;
}

/// A run as Python drives it.
class Run
{
public:
    Run(World world, WorldOptions options) : world_(std::move(world)), options_(std::move(options)) {}

    [[nodiscard]] World& world()
    {
        if (is_busy_) throw std::runtime_error("the world is on its way: another thread advances it");
        return world_;
    }

    /// Goes on in shares, between which Python may do other things, and may be interrupted.
    bool advance(double time, std::int64_t max_events)
    {
        World& world = this->world();
        EventShare at_once;
        if (std::isnan(time)) throw py::value_error("time: found nan, expected a number of seconds");
        std::int64_t left = max_events < 0 ? INT64_MAX : max_events;
        while (left > 0) {
            const std::int64_t share = std::min(left, at_once.size());
            const std::int64_t before = world.events();
            std::optional<RunFailure> failure;
            is_busy_ = true;
            {
                const py::gil_scoped_release others_may_run;
                const auto start = std::chrono::steady_clock::now();
                failure = world.advance(time, share);
                const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                seconds_ += seconds;
                at_once.took(seconds);
            }
            is_busy_ = false;
            if (failure) {
                failure_ = failure;
                raise_failure(*failure);
            }
            if (failure_) raise_failure(*failure_);
            const std::int64_t handled = world.events() - before;
            if (handled < share && world.time() >= time) return true;
            left -= std::max<std::int64_t>(handled, 1);
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        }
        return false;
    }

    [[nodiscard]] py::array_t<double> states()
    {
        const World& world = this->world();
        constexpr py::ssize_t k_columns = 6;
        py::array_t<double> array({static_cast<py::ssize_t>(world.body_count()), k_columns});
        auto rows = array.mutable_unchecked<2>();
        for (int k = 0; k < world.body_count(); ++k) {
            const BodyState s = world.state(k);
            const double row[] = {s.position.x(), s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin};
            for (int column = 0; column < k_columns; ++column) rows(k, column) = row[column];
        }
        return array;
    }

    [[nodiscard]] py::object outline(int body)
    {
        const World& world = this->world();
        if (body < 0 || body >= world.body_count()) throw py::index_error("no body number " + std::to_string(body));
        const Shape& shape = world.shape(body);
        if (const auto* disc = std::get_if<Disc>(&shape)) return py::float_(disc->radius);
        py::list rings;
        const auto& polygon = std::get<Polygon>(shape);
        const auto starts = polygon.ring_starts();
        for (std::size_t ring = 0; ring + 1 < starts.size(); ++ring) {
            py::array_t<double> vertices({static_cast<py::ssize_t>(starts[ring + 1] - starts[ring]), py::ssize_t{2}});
            auto rows = vertices.mutable_unchecked<2>();
            for (int k = starts[ring]; k < starts[ring + 1]; ++k) {
                const Vec2& vertex = polygon.vertices()[static_cast<std::size_t>(k)];
                rows(k - starts[ring], 0) = vertex.x();
                rows(k - starts[ring], 1) = vertex.y();
            }
            rings.append(vertices);
        }
        return rings;
    }

    [[nodiscard]] py::object report()
    {
        return py::module_::import("json").attr("loads")(report_json(world().report(), seconds_, failure_));
    }

    [[nodiscard]] std::string snapshot()
    {
        if (failure_) throw std::runtime_error("a run that failed can't go on: " + failure_->message);
        return write_saved_run(world().scene(), options_, world().snapshot());
    }

private:
    World world_;
    WorldOptions options_;
    std::optional<RunFailure> failure_;
    double seconds_ = 0.0; ///< that the engine took [s]
    bool is_busy_ = false; ///< a thread advances it, and left the interpreter to others
};

Run make_run(const py::object& scene, const std::string& engine, double step, const std::vector<std::string>& without)
{
    WorldOptions options = make_options(engine, step, without);
    World world = value_or_raise(World::make(read_scene(scene), options));
    return {std::move(world), std::move(options)};
}

Run resume_run(const py::object& scene_given, const std::string& snapshot)
{
    const Scene scene = read_scene(scene_given);
    SavedRun saved = value_or_raise(read_saved_run_text(snapshot, "snapshot", scene));
    World world = value_or_raise(World::resume(scene, saved.snapshot, saved.options));
    return {std::move(world), std::move(saved.options)};
}

// ---- Scenes ---------------------------------------------------------------------------------------------------------

py::list check_scene(const py::object& scene)
{
    const Expected<Scene> read = read_scene_text(scene_text(scene), "scene", make_room_for_digits);
    return read ? py::list() : fault_list(read.faults());
}

/// The words of the command line from an option's name and value.
std::string generate_scene(const std::string& kind, const py::kwargs& options)
{
    std::string words = kind;
    for (const auto& [key, value] : options) {
        std::string name = py::str(key);
        std::replace(name.begin(), name.end(), '_', '-');
        words += " --" + name;
        if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
            for (const py::handle& entry : value) words += " " + std::string(py::str(entry));
        } else {
            words += " " + std::string(py::str(value));
        }
    }
    return value_or_raise(generate_from_words(words));
}

} // namespace

} // namespace flying

PYBIND11_MODULE(flying, module)
{
    using flying::Run;
    module.doc() = "Rigid bodies in the plane: exact between impacts, measured where bodies rest on each other.";
    module.attr("COLUMNS") = py::make_tuple("x", "y", "angle", "vx", "vy", "spin");
    module.attr("__version__") = FLYING_VERSION;

    // Classes of errors that can hold what went wrong
    const py::dict home = module.attr("__dict__");
    py::exec(R"(
class SceneError(ValueError):
    """What is wrong with a scene, a line for each fault; `faults` has them as dicts {place, found, expected}."""
    faults = []

class RunError(RuntimeError):
    """Why a run can't go on; `time` [s] and `bodies` (numbers from 0) say when, and for which."""
    time = 0.0
    bodies = []
)",
             home);

    py::class_<Run>(module, "World", "A scene in motion. Moves forward only; the same bits on every machine.")
        .def(py::init(&flying::make_run), py::arg("scene"), py::kw_only(), py::arg("engine") = "auto",
             py::arg("step") = 1.0 / 60.0, py::arg("without") = std::vector<std::string>{},
             "scene: TOML text or a dict of the same keys. engine: auto, events or rest. step: of the resting "
             "integrator [s]. without: names of skips to leave inactive. Raises SceneError.")
        .def_static("resume", &flying::resume_run, py::arg("scene"), py::arg("snapshot"),
                    "A world that goes on from a snapshot of a run of the same scene, with the same bits.")
        .def("advance", &Run::advance, py::arg("time"), py::arg("max_events") = -1,
             "Move on to a time [s], or until that many events and steps more are done. True when there. Earlier times "
             "do nothing. Raises RunError.")
        .def_property_readonly(
            "time", [](Run& run) { return run.world().time(); }, "the clock [s]")
        .def_property_readonly(
            "until", [](Run& run) { return run.world().scene().until; }, "end of the scene [s]")
        .def("__len__", [](Run& run) { return run.world().body_count(); })
        .def_property_readonly(
            "names",
            [](Run& run) {
                std::vector<std::string> names;
                for (const flying::BodyDef& body : run.world().scene().bodies) names.push_back(body.name);
                return names;
            },
            "of the bodies, in the scene's order; empty where it has none")
        .def_property_readonly("events", [](Run& run) { return run.world().events(); })
        .def_property_readonly("collisions", [](Run& run) { return run.world().collisions(); })
        .def("states", &Run::states,
             "An array of a row for each body, its columns as COLUMNS: x, y [m], angle [rad], vx, vy [m/s], spin "
             "[rad/s].")
        .def("outline", &Run::outline, py::arg("body"),
             "How a body looks about its centre of mass [m]: of a disc its radius, of a polygon a list of rings, each "
             "an "
             "array of vertices (x, y); the first is its outline, the others are holes.")
        .def("report", &Run::report, "The report of `flying simulate --report` as a dict.")
        .def("snapshot", &Run::snapshot, "A text from which `resume` goes on.")
        .def(py::pickle(
            [](Run& run) { return py::make_tuple(flying::write_scene(run.world().scene()), run.snapshot()); },
            [](const py::tuple& state) { return flying::resume_run(state[0], state[1].cast<std::string>()); }));

    module.def("check", &flying::check_scene, py::arg("scene"),
               "Every fault of a scene, as dicts {place, found, expected}; an empty list where it is fit to run.");
    module.def("generate", &flying::generate_scene, py::arg("kind"),
               "A scene as TOML text, by kind and options as `flying generate` takes them: generate('gas', count=40, "
               "seed=7, radius=(0.1, 0.2)). The same seed, the same scene. Raises SceneError.");
    module.def(
        "to_toml", [](const py::object& scene) { return flying::write_scene(flying::read_scene(scene)); },
        py::arg("scene"), "The scene as TOML text. Raises SceneError.");
}
