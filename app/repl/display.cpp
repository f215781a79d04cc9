#include "app/repl/display.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "app/messages.h"
#include <fmt/ranges.h>

#include "runtime/geometry/tabulated_cylinder.h"
#include "runtime/region/region.h"
#include "runtime/spline/cubic.h"

namespace arelem::app::repl {

namespace {
constexpr std::size_t mostShown = 20;    // rows of one kind behind an entry
constexpr std::size_t mostNumbers = 24;  // of one entity

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

std::string number(double value, const Style& style) {
  const double shown = std::abs(value) < 1e-12 ? 0.0 : value;
  return fmt::format("{:.{}g}", shown, style.digits);
}

std::string place(const double* v, const Style& style) {
  return fmt::format("({}, {}, {})", number(v[0], style), number(v[1], style), number(v[2], style));
}

std::string lineInWords(const std::vector<double>& c, const Style& style) {
  const double x = c[0] * c[3];
  const double y = c[1] * c[3];
  double angle = degrees(std::atan2(c[0], -c[1]));
  angle = angle < 0.0 ? angle + 180.0 : angle;
  angle = angle >= 180.0 - 1e-9 ? 0.0 : angle;
  return fmt::format("through ({}, {}) at {} degrees to x", number(x, style), number(y, style),
                     number(angle, style));
}

std::string planeInWords(const std::vector<double>& c, const Style& style) {
  const std::array<double, 3> foot = {c[0] * c[3], c[1] * c[3], c[2] * c[3]};
  return fmt::format("normal {}  {} from the origin, at {}", place(c.data(), style),
                     number(c[3], style), place(foot.data(), style));
}

std::string roundInWords(const Entity& entity, const Style& style) {
  const std::vector<double>& c = entity.canon;
  switch (entity.type) {
    case EntityType::circle:
      return fmt::format("center ({}, {})  radius {}", number(c[0], style), number(c[1], style),
                         number(c[6], style));
    case EntityType::cylinder:
      return fmt::format("axis through {} along {}  radius {}", place(c.data(), style),
                         place(&c[3], style), number(c[6], style));
    case EntityType::sphere:
      return fmt::format("center {}  radius {}", place(c.data(), style), number(c[3], style));
    case EntityType::cone:
      return fmt::format("vertex {}  axis {}  half angle {} degrees", place(c.data(), style),
                         place(&c[3], style),
                         number(degrees(std::acos(std::clamp(c[6], -1.0, 1.0))), style));
    default:
      return fmt::format("center {}  axis {}  radius {}  of the tube {}", place(c.data(), style),
                         place(&c[3], style), number(c[6], style), number(c[7], style));
  }
}

std::string listed(const Entity& entity, const Style& style) {
  const std::size_t n = std::min(entity.canon.size(), mostNumbers);
  std::string text;
  for (std::size_t i = 0; i < n; ++i) {
    text += (i == 0 ? "" : " ") + number(entity.canon[i], style);
  }
  return n < entity.canon.size() ? text + fmt::format(" ... {} numbers", entity.canon.size())
                                 : text;
}

std::string patternInWords(const Entity& entity, const Style& style) {
  const std::vector<double>& c = entity.canon;
  if (c.size() < 3) {
    return "no points";
  }
  return fmt::format("{} points from {} to {}", c.size() / 3, place(c.data(), style),
                     place(&c[c.size() - 3], style));
}

/// "curve of 2 cubic pieces from (0, 0, 0) to (4, 0, 0), along (0, 0, 1)".
std::string tabulatedInWords(const Entity& entity, const Style& style) {
  const auto curve = geometry::TabulatedCylinder::of(entity.canon);
  std::vector<const geometry::TabulatedCylinder::Interval*> pieces;
  for (const auto& interval : curve.intervals) {
    if (!interval.extension) {
      pieces.push_back(&interval);
    }
  }
  if (pieces.empty()) {
    return listed(entity, style);
  }
  const Vec3 from = curve.inSpace(pieces.front()->start);
  const Vec3 to = curve.inSpace(pieces.back()->at(pieces.back()->length).place);
  const Vec3 along = curve.generatrix();
  return fmt::format("curve of {} from {} to {}, swept along {}",
                     counted(pieces.size(), "cubic piece"), place(from.data(), style),
                     place(to.data(), style), place(along.data(), style));
}

std::string splineInWords(const Entity& entity, const Style& style) {
  const auto curve = spline::CubicSpline::of(entity.canon);
  if (!curve) {
    return listed(entity, style);
  }
  const Vec3 from = curve->at(curve->begin());
  const Vec3 to = curve->at(curve->end());
  const std::string points = counted(curve->control().size(), "control point");
  return curve->closed()
             ? fmt::format("closed, {}, length {}", points, number(curve->length(), style))
             : fmt::format("from {} to {}, {}, length {}", place(from.data(), style),
                           place(to.data(), style), points, number(curve->length(), style));
}

std::string regionInWords(const Entity& entity, const Style& style) {
  if (!region::Region::readable(entity.canon)) {
    return listed(entity, style);
  }
  const region::Region area = region::Region::of(entity.canon);
  std::size_t corners = 0;
  for (const auto& loop : area.loops) {
    corners += loop.size();
  }
  return fmt::format("{} with {} in all, normal {}", counted(area.loops.size(), "outline"),
                     counted(corners, "corner"), place(area.normal.data(), style));
}

std::string label(const runtime::Defined& defined) {
  return defined.subscript == 0 ? defined.name
                                : fmt::format("{}({})", defined.name, defined.subscript);
}

/// Scalars by name and subscript.
std::map<std::pair<std::string, int>, double> scalarsOf(const Run& run) {
  std::map<std::pair<std::string, int>, double> values;
  for (const runtime::Defined& d : run.job.evaluation.defined) {
    if (!d.entity) {
      values[{d.name, d.subscript}] = d.scalar;
    }
  }
  return values;
}

void more(std::ostream& out, std::size_t shown, std::size_t all, const Style& style) {
  if (all > shown) {
    out << inked(style, Ink::faint, fmt::format("... and {} more", all - shown)) << '\n';
  }
}

void printDefinitions(std::ostream& out, const Run& run, const Run& before, const Style& style) {
  const auto& history = run.job.evaluation.history;
  std::vector<runtime::Defined> news;
  for (std::size_t i = before.job.evaluation.history.size(); i < history.size(); ++i) {
    if (history[i].entity && !history[i].name.empty()) {
      news.push_back(history[i]);
    }
  }
  const auto old = scalarsOf(before);
  for (const runtime::Defined& d : run.job.evaluation.defined) {
    const auto known = d.entity ? old.end() : old.find({d.name, d.subscript});
    if (!d.entity && (known == old.end() || known->second != d.scalar)) {
      news.push_back(d);
    }
  }
  for (std::size_t i = 0; i < std::min(news.size(), mostShown); ++i) {
    printDefined(out, news[i], style);
  }
  more(out, mostShown, news.size(), style);
}

void printPrinted(std::ostream& out, const Run& run, const Run& before, const Style& style) {
  const auto& printed = run.job.evaluation.printed;
  for (std::size_t i = before.job.evaluation.printed.size(); i < printed.size(); ++i) {
    const runtime::Printed& p = printed[i];
    if (!p.title.empty()) {
      out << p.title << '\n';
    } else if (p.undefined) {
      out << p.name << " has no value\n";
    } else {
      printDefined(out, {p.name, p.subscript, p.entity, p.scalar, {}}, style);
    }
  }
}
}  // namespace

std::string inked(const Style& style, Ink ink, const std::string& text) {
  constexpr std::array codes = {"1;36", "35", "2", "32", "31"};
  return style.color
             ? fmt::format("\033[{}m{}\033[0m", codes.at(static_cast<std::size_t>(ink)), text)
             : text;
}

std::string readable(const Entity& entity, const Style& style) {
  switch (entity.type) {
    case EntityType::point:
      return place(entity.canon.data(), style);
    case EntityType::vector:
      return fmt::format(
          "{}  length {}", place(entity.canon.data(), style),
          number(std::hypot(entity.canon[0], entity.canon[1], entity.canon[2]), style));
    case EntityType::line:
      return lineInWords(entity.canon, style);
    case EntityType::plane:
      return planeInWords(entity.canon, style);
    case EntityType::circle:
    case EntityType::cylinder:
    case EntityType::sphere:
    case EntityType::cone:
    case EntityType::torus:
      return roundInWords(entity, style);
    case EntityType::pattern:
      return patternInWords(entity, style);
    case EntityType::tabulatedCylinder:
      return tabulatedInWords(entity, style);
    case EntityType::pathSpline:
      return splineInWords(entity, style);
    case EntityType::region:
      return regionInWords(entity, style);
    default:
      return listed(entity, style);
  }
}

std::string exactNumbers(std::span<const double> values) {
  const std::size_t n = std::min(values.size(), mostNumbers);
  std::string text = fmt::format("{}", fmt::join(values.first(n), " "));
  return n < values.size() ? text + fmt::format(" ... {} numbers", values.size()) : text;
}

void printDefined(std::ostream& out, const runtime::Defined& defined, const Style& style) {
  const std::string name = inked(style, Ink::name, label(defined));
  if (!defined.entity) {
    out << name << " = " << number(defined.scalar, style);
    if (style.exact && fmt::format("{}", defined.scalar) != number(defined.scalar, style)) {
      out << inked(style, Ink::faint, fmt::format("   exactly {}", defined.scalar));
    }
    out << '\n';
    return;
  }
  out << name << " = " << inked(style, Ink::kind, std::string(spell(defined.entity->type))) << "  "
      << readable(*defined.entity, style) << '\n';
  if (style.exact) {
    out << inked(style, Ink::faint, "   exactly " + exactNumbers(defined.entity->canon)) << '\n';
  }
}

void printMotion(std::ostream& out,
                 const runtime::MotionFact& fact,
                 const std::string& unit,
                 const Style& style) {
  out << inked(style, Ink::name, fact.statement)
      << fmt::format("  {}, {} {}", counted(fact.cutVectors, "cut vector"),
                     number(fact.length, style), unit);
  const double inner = std::min(fact.driveInner, fact.partInner);
  const double outer = std::max(fact.driveOuter, fact.partOuter);
  if (inner != 0.0 || outer != 0.0) {
    out << fmt::format("  off its surfaces by {:.3g} to {:.3g}", inner, outer);
  }
  out << '\n';
}

std::optional<Vec3> lastPlace(const cl::Recording& path) {
  for (auto record = path.records.rbegin(); record != path.records.rend(); ++record) {
    const auto* motion = std::get_if<cl::Motion>(&record->body);
    if (motion != nullptr && motion->points() > 0) {
      const double* last = &motion->coordinates[(motion->points() - 1) * motion->stride()];
      return Vec3(last[0], last[1], last[2]);
    }
  }
  return std::nullopt;
}

std::string unitOf(const Run& run) {
  std::string unit = "in";
  bool named = false;
  for (const runtime::Action& action : run.job.evaluation.actions) {
    if (const auto* pass = std::get_if<runtime::Pass>(&action.body)) {
      if (const auto* units = std::get_if<cl::Units>(&pass->body)) {
        unit = spell(units->unit);
        named = true;
      }
    }
  }
  std::transform(unit.begin(), unit.end(), unit.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return named ? unit : "units";
}

void printNews(std::ostream& out, const Run& run, const Run& before, const Style& style) {
  printDefinitions(out, run, before, style);
  printPrinted(out, run, before, style);
  const auto& facts = run.job.motion.facts;
  const std::size_t known = before.job.motion.facts.size();
  const std::string unit = unitOf(run);
  for (std::size_t i = known; i < std::min(facts.size(), known + mostShown); ++i) {
    printMotion(out, facts[i], unit, style);
  }
  if (facts.size() > known) {
    more(out, mostShown, facts.size() - known, style);
    if (const std::optional<Vec3> end = lastPlace(*run.path)) {
      out << "   the tool stands at " << place(end->data(), style) << '\n';
    }
  }
  if (run.waiting) {
    out << inked(style, Ink::faint, "   waits for the next motion, which tells where it ends")
        << '\n';
  }
}

}  // namespace arelem::app::repl
