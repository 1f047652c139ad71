#include "python/scene_text.hpp"

#include <nlohmann/json.hpp>
#include <pybind11/numpy.h>

namespace flying {

namespace py = pybind11;

namespace {

/// TOML's quoted strings are JSON's.
std::string quoted(const std::string& text)
{
    return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

[[noreturn]] void refuse(const std::string& path, const py::handle& value)
{
    const std::string type = py::str(py::type::handle_of(value).attr("__name__"));
    throw py::type_error((path.empty() ? "the scene" : path) + ": found " + type +
                         ", expected what TOML can say: a number, a text, a list or a dict");
}

std::string value_text(const py::handle& value, const std::string& path);

std::string table_text(const py::dict& table, const std::string& path)
{
    std::string text;
    for (const auto& [key, value] : table) {
        if (!py::isinstance<py::str>(key)) refuse(path + (path.empty() ? "a key" : ", a key"), key);
        const std::string name = py::str(key);
        text += (text.empty() ? "" : ", ") + quoted(name) + " = " +
                value_text(value, path.empty() ? name : path + "." + name);
    }
    return "{ " + text + " }";
}

std::string list_text(const py::handle& list, const std::string& path, const char* separator)
{
    std::string text;
    int index = 0;
    for (const py::handle& entry : list) {
        text += (index == 0 ? "" : separator) + value_text(entry, path + "[" + std::to_string(index) + "]");
        ++index;
    }
    return "[" + text + "]";
}

std::string value_text(const py::handle& value, const std::string& path)
{
    // NumPy's arrays and numbers as Python's own
    if (py::isinstance<py::array>(value)) return value_text(value.attr("tolist")(), path);
    if (py::hasattr(value, "dtype") && py::hasattr(value, "item")) return value_text(value.attr("item")(), path);

    if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
    if (py::isinstance<py::int_>(value) || py::isinstance<py::float_>(value)) return py::repr(value);
    if (py::isinstance<py::str>(value)) return quoted(py::str(value));
    if (py::isinstance<py::dict>(value)) return table_text(value.cast<py::dict>(), path);
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) return list_text(value, path, ", ");
    refuse(path, value);
}

} // namespace

std::string scene_text(const py::object& scene)
{
    if (py::isinstance<py::str>(scene)) return py::str(scene);
    if (!py::isinstance<py::dict>(scene)) {
        const std::string type = py::str(py::type::handle_of(scene).attr("__name__"));
        throw py::type_error("the scene: found " + type + ", expected TOML text or a dict");
    }
    std::string text;
    for (const auto& [key, value] : scene.cast<py::dict>()) {
        if (!py::isinstance<py::str>(key)) refuse("a key", key);
        const std::string name = py::str(key);
        const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
        text += quoted(name) + " = " + (is_list ? list_text(value, name, ",\n") : value_text(value, name)) + "\n";
    }
    return text;
}

} // namespace flying
