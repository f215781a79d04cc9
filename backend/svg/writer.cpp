#include "backend/svg/writer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>

#include <fmt/format.h>

#include "backend/svg/geometry.h"
#include "backend/svg/legend.h"
#include "backend/svg/path_drawer.h"
#include "backend/svg/solid.h"
#include "ir/hole/drilled.h"

namespace arelem::backend {

namespace {
using namespace svg;

constexpr std::size_t mostVertices = 20000;
constexpr std::size_t fewVertices = 3000;  // are drawn as they are
constexpr std::size_t mostEntities = 500;
constexpr std::size_t mostOutlines = 24;
constexpr double thinnedPixels = 0.05;
constexpr double geometryReach = 0.2;  // of the path's size: how far geometry may widen the picture
constexpr double border = 0.04;
constexpr double aroundStart = 6.0;  // of the cutter's radius: shown of a path that is only a start

class PictureWriter : public Writer {
 public:
  PictureWriter(std::ostream& out,
                const Context& context,
                PictureViews views,
                const Shortcomings& shortcomings)
      : out_(out), context_(context), views_(views), wrong_(shortcomings), path_(mostVertices) {}

  void accept(const cl::Record& record) override { holes_.accept(record); }

  void finish() override {
    path_.finish();
    const Layout page = arrange(pathBounds(), seen(), views_);
    const double scale = page.views.front().scale;
    if (path_.vertices().size() > fewVertices) {
      path_.thin(thinnedPixels / scale);
    }
    Canvas canvas(out_, page.width, page.height);
    const std::string title = path_.partName().empty() ? "Tool path" : path_.partName();
    canvas.begin(title, fmt::format("Tool path of {} locations", path_.locations()));
    canvas.text({24, 30}, title, "class=\"title\"");
    canvas.text({24, 49}, extents() + (wrong_.remark.empty() ? "" : "   " + wrong_.remark),
                "class=\"soft\"");
    if (!wrong_.warning.empty()) {
      canvas.text({24, 64}, wrong_.warning, "class=\"wrong\"");
    }
    drawn_.assign(context_.entities.size(), false);
    int id = 0;
    for (const View& view : page.views) {
      drawView(canvas, view, id++);
    }
    if (page.solid) {
      drawSolid(canvas, *page.solid, path_.vertices(), id++);
    }
    if (path_.locations() <= 1) {
      drawStandstill(canvas, page.views.front().box);
    }
    const bool geometry = std::find(drawn_.begin(), drawn_.end(), true) != drawn_.end();
    drawLegend(canvas, page.legend,
               {path_, scale, path_.vertices().size(), outlines_, geometry, !wrong_.marks.empty(),
                notDrawn(), namesLeft()});
    canvas.end();
    out_.flush();
  }

 private:
  const Curves& curvesOf(std::size_t i) const {
    static const Curves none;
    return i < context_.curves.size() ? context_.curves[i] : none;
  }
  void addGeometry(Bounds& bounds) const {
    for (std::size_t i = 0; i < context_.entities.size(); ++i) {
      addExtent(*context_.entities[i], curvesOf(i), bounds);
    }
  }
  /// Of the path, or of the geometry where there is no path.
  Bounds pathBounds() const {
    if (!path_.bounds().empty) {
      return path_.bounds();
    }
    Bounds bounds;
    addGeometry(bounds);
    return bounds;
  }
  /// The path with its cutter, widened a little for the geometry near it.
  Bounds seen() const {
    const Bounds path = pathBounds();
    Bounds box = path;
    const double radius = 0.5 * path_.cutterDiameter();
    const Vec3 tool(radius, radius, 0.0);
    const bool stands = path_.locations() <= 1;
    const double reach =
        stands ? std::numeric_limits<double>::infinity() : geometryReach * path.size().norm();
    Bounds geometry;
    addGeometry(geometry);
    if (!geometry.empty) {
      const Vec3 flat(reach, reach, 0.0);  // heights come from the path alone
      box.add(geometry.low.cwiseMax(path.low - flat).cwiseMin(path.high + flat));
      box.add(geometry.high.cwiseMin(path.high + flat).cwiseMax(path.low - flat));
    }
    box.add(path.low - tool);
    box.add(path.high + tool);
    if (stands && !path_.bounds().empty) {  // the cutter alone would fill the picture
      box.add(path.low - aroundStart * tool);
      box.add(path.high + aroundStart * tool);
    }
    const Vec3 frame = Vec3::Constant(border * box.size().maxCoeff());
    const Bounds inner = box;
    box.add(inner.low - frame);
    box.add(inner.high + frame);
    return box;
  }
  std::string extents() const {
    const Bounds& b = path_.bounds();
    if (b.empty) {
      return "no motion";
    }
    return fmt::format("X {},  Y {},  Z {}{}", rangeText(b.low.x(), b.high.x()),
                       rangeText(b.low.y(), b.high.y()), rangeText(b.low.z(), b.high.z()),
                       path_.unit().empty() ? "" : "  " + path_.unit());
  }
  /// What no view shows, by kind.
  std::string notDrawn() const {
    std::map<std::string_view, int> kinds;
    for (std::size_t i = 0; i < context_.entities.size(); ++i) {
      if (!drawn_[i]) {
        ++kinds[spell(context_.entities[i]->type)];
      }
    }
    std::string words;
    for (const auto& [kind, count] : kinds) {
      words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, kind);
    }
    return words;
  }

  void drawView(Canvas& canvas, const View& view, int id) {
    canvas.text({view.box.left, view.box.top - 7}, view.name, "class=\"soft\"");
    canvas.rectangle(view.box, "class=\"frame\"");
    canvas.beginClip(view.box, id);
    GeometryDrawer geometry(canvas, view);
    PathDrawer path(canvas, view, path_.vertices());
    path.reserve(geometry.labels());
    for (std::size_t i = 0; i < std::min(context_.entities.size(), mostEntities); ++i) {
      drawn_[i] = geometry.draw(*context_.entities[i], curvesOf(i)) || drawn_[i];
    }
    if (view.depth == 2) {
      drawOutlines(canvas, view);
    }
    path.draw();
    drawFaults(canvas, view, geometry.labels());
    const std::vector<std::string> left = geometry.drawNames();
    unnamed_.insert(unnamed_.end(), left.begin(), left.end());
    const auto& named = geometry.labels().drawn();
    named_.insert(named.begin(), named.end());
    canvas.endGroup();
    drawEnds(canvas, view);
  }
  void drawOutlines(Canvas& canvas, const View& view) {
    const double radius = 0.5 * path_.cutterDiameter() * view.scale;
    const std::vector<Vec3>& stops = path_.stops();
    if (radius < 2.0 || stops.empty()) {
      return;
    }
    const std::size_t count = std::min(stops.size(), mostOutlines);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = count == 1 ? 0 : i * (stops.size() - 1) / (count - 1);
      canvas.circle(view(stops[at]), radius, "class=\"tool\"");
    }
    outlines_ = count;
  }
  /// Where motions are missing: a cross, and the way of the next motion, which does not begin where
  /// the program meant.
  void drawFaults(Canvas& canvas, const View& view, Labels& labels) const {
    constexpr double arm = 5.0;  // pixels
    constexpr std::size_t mostWords = 18;
    std::vector<std::pair<Pixel, std::string>> places;  // lines at fault by where they are marked
    for (const FaultMark& mark : wrong_.marks) {
      const Pixel p = view(mark.place);
      if (mark.next) {
        canvas.line(p, view(*mark.next), "class=\"doubt\"");
      }
      canvas.line({p.x - arm, p.y - arm}, {p.x + arm, p.y + arm}, "class=\"fault\"");
      canvas.line({p.x - arm, p.y + arm}, {p.x + arm, p.y - arm}, "class=\"fault\"");
      const auto same = std::find_if(places.begin(), places.end(), [&](const auto& other) {
        return std::hypot(other.first.x - p.x, other.first.y - p.y) < arm;
      });
      if (same == places.end()) {
        places.emplace_back(p, fmt::format("line {}", mark.line));
      } else if (same->second.size() < mostWords) {
        same->second += fmt::format(", {}", mark.line);
      }
    }
    for (const auto& [place, words] : places) {
      labels.addFirst(words, place);
    }
  }
  /// What an empty picture tells.
  void drawStandstill(Canvas& canvas, const Box& box) const {
    const bool stands = path_.locations() == 1;
    canvas.text(
        {box.left + 12, box.top + 22},
        stands ? "the tool stands where it starts: no motion could be computed" : "no motion",
        wrong_.warning.empty() ? "class=\"soft\"" : "class=\"wrong\"");
  }
  std::size_t namesLeft() const {
    const std::set<std::string> left(unnamed_.begin(), unnamed_.end());
    return static_cast<std::size_t>(std::count_if(
        left.begin(), left.end(), [this](const auto& name) { return !named_.contains(name); }));
  }
  void drawEnds(Canvas& canvas, const View& view) const {
    if (!path_.vertices().empty()) {
      canvas.circle(view(path_.vertices().back().place), 5.5, "class=\"finish\"");
      canvas.circle(view(path_.vertices().front().place), 3.8, "class=\"begin\"");
    }
  }

  std::ostream& out_;
  const Context& context_;
  PictureViews views_;
  const Shortcomings& wrong_;
  PathCollector path_;
  hole::Drilled holes_{path_};
  std::size_t outlines_ = 0;
  std::vector<bool> drawn_;           // by entity: some view shows it
  std::vector<std::string> unnamed_;  // names for which some view had no room
  std::set<std::string> named_;       // names that some view shows
};
}  // namespace

std::unique_ptr<Writer> makePictureWriter(std::ostream& out,
                                          const Context& context,
                                          DiagnosticSink&) {
  static const Shortcomings none;
  return makePictureWriter(out, context, PictureViews::automatic, none);
}

std::unique_ptr<Writer> makePictureWriter(std::ostream& out,
                                          const Context& context,
                                          PictureViews views,
                                          const Shortcomings& shortcomings) {
  return std::make_unique<PictureWriter>(out, context, views, shortcomings);
}

}  // namespace arelem::backend
