#include "backend/html/page.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>

#include <nlohmann/json.hpp>

#include "backend/html/base64.h"
#include "backend/html/deflate.h"
#include "backend/html/detail.h"
#include "backend/html/scene.h"
#include "backend/text/clean.h"

namespace arelem::backend {

namespace {
using Json = nlohmann::ordered_json;

/// JSON that can stand in a page: no `<` opens a tag, bad bytes are replaced.
std::string safe(const Json& value) {
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    c == '<' ? result += "\\u003c" : result += c;
  }
  return result;
}

/// Text for the title of a page.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '&':
        result += "&amp;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

std::string nameOf(const Entity& entity) {
  return entity.subscript == 0 ? entity.name
                               : entity.name + "(" + std::to_string(entity.subscript) + ")";
}

Json entitiesOf(const Scene& scene) {
  Json all = Json::array();
  for (std::size_t i = 0; i < scene.entities.size(); ++i) {
    const EntityPtr& entity = scene.entities[i];
    const bool finite = std::all_of(entity->canon.begin(), entity->canon.end(),
                                    [](double v) { return std::isfinite(v); });
    if (finite && entity->canon.size() <= 4000) {
      all.push_back(
          {{"name", nameOf(*entity)}, {"type", spell(entity->type)}, {"canon", entity->canon}});
      for (const auto& curve : scene.curves[i]) {
        Json places = Json::array();
        for (const Vec3& p : curve) {
          places.insert(places.end(), {p.x(), p.y(), p.z()});
        }
        all.back()["curves"].push_back(std::move(places));
      }
    }
  }
  return all;
}

Json headOf(const Scene& scene) {
  Json head = {{"title", scene.title},         {"unit", scene.unit},
               {"timed", scene.timed},         {"gunStandOff", scene.gunStandOff},
               {"gunRadius", scene.gunRadius}, {"locations", scene.kinds.size()}};
  head["sources"] = Json::array();
  for (const SceneSource& source : scene.sources) {
    head["sources"].push_back({{"name", source.name}});
  }
  head["messages"] = Json::array();
  for (const SceneMessage& m : scene.messages) {
    head["messages"].push_back({{"error", m.error},
                                {"code", m.code},
                                {"text", m.text},
                                {"file", m.file},
                                {"line", m.line}});
  }
  head["cutters"] = Json::array();
  for (const SceneCutter& c : scene.cutters) {
    head["cutters"].push_back({{"first", c.first}, {"diameter", c.diameter}, {"corner", c.corner}});
  }
  head["faults"] = Json::array();
  for (const FaultMark& mark : scene.faults) {
    const Vec3 next = mark.next.value_or(mark.place);
    head["faults"].push_back({{"line", mark.line},
                              {"place", {mark.place.x(), mark.place.y(), mark.place.z()}},
                              {"next", {next.x(), next.y(), next.z()}}});
  }
  head["meshes"] = Json::array();
  for (const SceneMesh& mesh : scene.meshes) {
    head["meshes"].push_back({{"name", mesh.name}, {"auxiliary", mesh.auxiliary}});
  }
  head["box"] = scene.box;
  head["block"] = Detail::blockLength;
  head["films"] = Json::array();
  for (const SceneFilm& film : scene.films) {
    head["films"].push_back({{"name", film.name},
                             {"wanted", film.wanted},
                             {"relative", film.relative},
                             {"strips", film.strips},
                             {"columns", film.columns},
                             {"rows", film.rows}});
  }
  head["entities"] = entitiesOf(scene);
  return head;
}

void element(std::ostream& out,
             const std::string& id,
             std::size_t count,
             std::span<const unsigned char> bytes) {
  out << "<script type=\"text/plain\" id=\"" << id << '"';
  if (count > 0) {
    out << " data-count=\"" << count << '"';
  }
  out << '>';
  writeBase64(out, deflated(bytes));
  out << "</script>\n";
}

/// An array whose values are all the same has one of them, and how often.
template <class T>
void blob(std::ostream& out, const std::string& id, const std::vector<T>& values) {
  const bool same = values.size() > 1 && std::all_of(values.begin(), values.end(), [&](const T& v) {
                      return std::memcmp(&v, values.data(), sizeof(T)) == 0;
                    });
  const std::size_t count = same ? 1 : values.size();
  element(out, id, same ? values.size() : 0,
          {reinterpret_cast<const unsigned char*>(values.data()),  // NOLINT: their bytes
           count * sizeof(T)});
}

template <class T, class Take>
std::vector<T> column(const std::vector<SceneStretch>& stretches, Take take) {
  std::vector<T> values;
  values.reserve(stretches.size());
  std::transform(stretches.begin(), stretches.end(), std::back_inserter(values), take);
  return values;
}

/// Levels of detail, and the texts of the program.
void writeShown(std::ostream& out, const Scene& scene) {
  const Detail detail = detailOf(scene.places, scene.kinds);
  blob(out, "levels", detail.levels);
  blob(out, "boxes", detail.boxes);
  std::vector<double> tolerances;
  for (int level = 0; level <= Detail::highest; ++level) {
    tolerances.push_back(detail.tolerance(level));
  }
  blob(out, "tolerances", tolerances);
  for (std::size_t i = 0; i < scene.sources.size(); ++i) {
    const std::string& text = scene.sources[i].text;
    element(out, "source" + std::to_string(i), 0,
            {reinterpret_cast<const unsigned char*>(text.data()), text.size()});  // NOLINT: bytes
  }
}

void writeData(std::ostream& out, const Scene& scene) {
  out << "<script type=\"application/json\" id=\"scene\">" << safe(headOf(scene)) << "</script>\n";
  writeShown(out, scene);
  blob(out, "places", scene.places);
  blob(out, "axes", scene.axes);
  blob(out, "kinds", scene.kinds);
  blob(out, "seconds", scene.seconds);
  const auto& s = scene.stretches;
  blob(out, "first", column<std::uint32_t>(s, [](const SceneStretch& t) { return t.first; }));
  blob(out, "line", column<std::uint32_t>(s, [](const SceneStretch& t) { return t.line; }));
  blob(out, "file", column<std::uint32_t>(s, [](const SceneStretch& t) { return t.file; }));
  blob(out, "feed", column<float>(s, [](const SceneStretch& t) { return t.feed; }));
  blob(out, "inner", column<float>(s, [](const SceneStretch& t) { return t.inner; }));
  blob(out, "outer", column<float>(s, [](const SceneStretch& t) { return t.outer; }));
  blob(out, "allowedInner", column<float>(s, [](const SceneStretch& t) { return t.allowedInner; }));
  blob(out, "allowedOuter", column<float>(s, [](const SceneStretch& t) { return t.allowedOuter; }));
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const std::string n = std::to_string(i);
    blob(out, "meshPlaces" + n, scene.meshes[i].places);
    blob(out, "meshNormals" + n, scene.meshes[i].normals);
    blob(out, "meshTriangles" + n, scene.meshes[i].triangles);
  }
  for (std::size_t i = 0; i < scene.films.size(); ++i) {
    blob(out, "filmCorners" + std::to_string(i), scene.films[i].corners);
    blob(out, "film" + std::to_string(i), scene.films[i].film);
  }
}
}  // namespace

void writePage(std::ostream& out, const Scene& scene) {
  std::string_view page = viewerPage();
  const auto upTo = [&](std::string_view mark) {
    const std::size_t at = page.find(mark);
    const std::string_view part = page.substr(0, at);
    page.remove_prefix(at == std::string_view::npos ? page.size() : at + mark.size());
    return part;
  };
  out << upTo("<!--TITLE-->") << escaped(scene.title) << upTo("<!--STYLE-->") << viewerStyle()
      << upTo("<!--DATA-->");
  writeData(out, scene);
  out << upTo("<!--SCRIPT-->") << viewerScript() << page;
}

}  // namespace arelem::backend
