// :curve, what a path spline is like: its Bezier pieces, and its derivatives and curvature at a
// place.
#include <charconv>
#include <cmath>

#include "app/repl/console.h"

#include "ir/diag/display_text.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/shapes.h"
#include "runtime/spline/cubic.h"

namespace arelem::app::repl {

namespace {

using spline::CubicSpline;

constexpr int samplesOfAPiece = 50;
constexpr std::size_t mostPieces = 100;

std::string number(double value, const Style& style) {
  return fmt::format("{:.{}g}", value == 0.0 ? 0.0 : value, style.digits);
}
std::string place(const Vec3& p, const Style& style) {
  return fmt::format("({}, {}, {})", number(p.x(), style), number(p.y(), style),
                     number(p.z(), style));
}

void tellWhole(std::ostream& out, const CubicSpline& curve, const Style& style) {
  const spline::CurvatureFigures figures = curvatureFigures(curve, samplesOfAPiece);
  out << fmt::format("   {}, {} control points, t from {} to {}, length {}\n",
                     curve.closed() ? "closed" : "open", curve.control().size(),
                     number(curve.begin(), style), number(curve.end(), style),
                     number(curve.length(), style))
      << fmt::format("   curvature at most {}, {} over its length\n", number(figures.most, style),
                     number(figures.mean, style));
  for (std::size_t i = 0; i < std::min(curve.spans(), mostPieces); ++i) {
    const spline::Bezier piece = curve.piece(i);
    out << fmt::format("   piece {}  t from {} to {}  Bezier points", i + 1,
                       number(piece.begin, style), number(piece.end, style));
    for (const Vec3& p : piece.control) {
      out << ' ' << place(p, style);
    }
    out << '\n';
  }
  if (curve.spans() > mostPieces) {
    out << fmt::format("   ... and {} more pieces\n", curve.spans() - mostPieces);
  }
}

void tellAt(std::ostream& out, const CubicSpline& curve, double t, const Style& style) {
  const CubicSpline::Derivatives at = curve.derivatives(t);
  const double curvature = curve.curvature(t);
  out << fmt::format("   t {}  point {}\n", number(t, style), place(at.point, style))
      << fmt::format("   derivatives {}, {}, {}\n", place(at.first, style), place(at.second, style),
                     place(at.third, style))
      << fmt::format("   direction {}  curvature {}", place(at.first.normalized(), style),
                     number(curvature, style));
  if (curvature > tolerance::symmetric) {
    const Vec3 along = at.first.normalized();
    const Vec3 inward = (at.second - at.second.dot(along) * along).normalized();
    out << fmt::format("  radius {}  center {}", number(1.0 / curvature, style),
                       place(at.point + inward / curvature, style));
  }
  out << '\n';
}

std::optional<double> numberIn(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t");
  if (from == std::string::npos) {
    return std::nullopt;
  }
  double value = 0.0;
  const char* last = text.data() + text.find_last_not_of(" \t") + 1;
  const auto [end, error] = std::from_chars(text.data() + from, last, value);
  return error == std::errc() && end == last ? std::optional(value) : std::nullopt;
}

/// The second word: a parameter, or a point that the curve comes next to there.
std::string tellPlace(Console& console, const CubicSpline& curve, const std::string& text) {
  const NamePart name = nameOf(console, text);
  const runtime::Defined* defined = findDefined(console, name);
  std::optional<double> t = numberIn(text);
  if (defined != nullptr && defined->entity && defined->entity->type == EntityType::point) {
    const CubicSpline::Nearest nearest =
        curve.nearest(geometry::Point::of(defined->entity->canon).at);
    console.out << fmt::format("   next to {}, {} away\n", name.name,
                               number(nearest.distance, console.style));
    t = nearest.t;
  } else if (defined != nullptr && !defined->entity) {
    t = defined->scalar;
  }
  if (!t) {
    return "`" + displayText(text) + "` is neither a number nor a point or scalar of the session";
  }
  if (!curve.closed() && !(*t >= curve.begin() && *t <= curve.end())) {
    return fmt::format("the parameter {} is outside of {} to {}", *t, curve.begin(), curve.end());
  }
  tellAt(console.out, curve, *t, console.style);
  return "";
}

}  // namespace

std::string tellCurve(Console& console, const std::string& rest) {
  const std::size_t comma = rest.find(',');
  const NamePart name = nameOf(console, rest.substr(0, comma));
  const runtime::Defined* defined = findDefined(console, name);
  if (defined == nullptr) {
    return name.name.empty() ? "a name is missing"
                             : "there is no value of `" + displayText(name.name) + "`";
  }
  if (!defined->entity || defined->entity->type != EntityType::pathSpline) {
    return "`" + displayText(name.name) + "` is no BSPLIN";
  }
  const Result<CubicSpline> curve = CubicSpline::of(defined->entity->canon);
  if (!curve) {
    return curve.failure().message;
  }
  if (comma != std::string::npos) {
    return tellPlace(console, *curve, rest.substr(comma + 1));
  }
  tellWhole(console.out, *curve, console.style);
  return "";
}

}  // namespace arelem::app::repl
