#include "runtime/certify/modal.h"

#include <algorithm>

#include "ir/space/tolerance.h"
#include "runtime/geometry/title.h"
#include "runtime/tool/profile_check.h"

namespace arelem::certify {

namespace {
surface::Foot footOn(const surface::AnySurface& any, const Vec3& place) {
  return std::visit(
      [&]<class S>(const S& s) {
        typename S::Hint hint{};
        return s.foot(place, hint);
      },
      any);
}

/// One to four values for part, drive, check and second check surface: the last one repeats.
std::array<double, 4> spread(const std::vector<double>& values) {
  std::array<double, 4> all{};
  for (std::size_t i = 0; i < all.size() && !values.empty(); ++i) {
    all[i] = values[std::min(i, values.size() - 1)];
  }
  return all;
}
}  // namespace

Result<Named> named(const EntityPtr& entity) {
  auto found = surface::surfaceOf(*entity);
  if (!found) {
    return found.takeFailure();
  }
  return Named{*std::move(found), surface::titleOf(*entity)};
}

bool Modal::apply(const runtime::Action& action) {
  if (const auto* parameter = std::get_if<runtime::Parameter>(&action.body)) {
    set(*parameter);
  } else if (const auto* ring = std::get_if<runtime::CutterOption>(&action.body)) {
    auto& slot = option[ring->surface == 1 ? partRole : driveRole];
    slot.reset();
    if (ring->ring) {
      slot = tool::makeRing((*ring->ring)[0], (*ring->ring)[1]);
    }
  } else if (const auto* relation = std::get_if<runtime::ToolRelation>(&action.body)) {
    if (relation->word == Word::TLONPS || relation->word == Word::TLOFPS) {
      partRelation = relation->word;
    } else {
      driveRelation = relation->word;
    }
  } else if (const auto* ps = std::get_if<runtime::PartSurface>(&action.body)) {
    if (auto surface = named(ps->surface)) {
      part = *std::move(surface);
    }
    startedOffPart = false;
  } else if (const auto* rule = std::get_if<runtime::ToolAxis>(&action.body)) {
    axisRule = *rule;
    if (rule->kind == runtime::ToolAxis::Kind::vector &&
        rule->vector.norm() > tolerance::nullDirection) {
      axis = rule->vector.normalized();
    }
  } else if (const auto* direction = std::get_if<runtime::Direction>(&action.body)) {
    if (direction->word == Word::SRFVCT) {
      surfaceVector = direction->values;
    }
  } else if (const auto* toggle = std::get_if<runtime::Toggle>(&action.body)) {
    output = toggle->word == Word::CUT || (output && toggle->word != Word::DNTCUT);
    staysOn = staysOn || toggle->word == Word::TLON;
    ignorePart = ignorePart || toggle->word == Word::NOPS;
    automaticPart = automaticPart || toggle->word == Word::AUTOPS;
  } else {
    return false;
  }
  return true;
}

void Modal::set(const runtime::Parameter& p) {
  switch (p.word) {
    case Word::INTOL:
      inner = spread(p.values);
      break;
    case Word::OUTTOL:
      outer = spread(p.values);
      break;
    case Word::TOLER:
      outer = spread(p.values);
      inner = {};
      break;
    case Word::THICK:
      thick = spread(p.values);
      break;
    case Word::CUTTER:
      if (auto profile = tool::makeProfile(p.values)) {
        cutter = tool::joined(*profile);
        option = {};
      }
      break;
    default:
      break;
  }
}

void Modal::takeAutomaticPart() {
  if (automaticPart) {
    part = Named{surface::Plane{Vec3::UnitZ(), toolEnd.z()}, "(AUTOPS)"};
  }
}

void Modal::consumeOneShots() {
  surfaceVector = {};
  standsOn = false;
  ignorePart = false;
  automaticPart = false;
}

bool Modal::isLeftOn(const surface::AnySurface& drive, const Vec3& end) const {
  const auto* line = std::get_if<surface::Plane>(&drive);
  const tool::Profile* tool = cutterFor(driveRole);
  const double reach = inner[driveRole] + outer[driveRole] + tolerance::startLength;
  return staysOn && line != nullptr && tool != nullptr && tool->maxRadius() > reach &&
         (driveRelation == Word::TLLFT || driveRelation == Word::TLRGT) &&
         thick[driveRole] == 0.0 && std::abs(line->normal.dot(axis)) <= tolerance::symmetric &&
         std::abs(line->normal.dot(end) - line->offset) <= reach;
}

Named Modal::partSurface() const {
  return part ? *part : Named{surface::Plane{Vec3::UnitZ(), 0.0}, "(XY plane)"};
}

const tool::Profile* Modal::cutterFor(Role role) const {
  if (role <= driveRole && option[role]) {
    return &*option[role];
  }
  return cutter ? &*cutter : nullptr;
}

Vec3 Modal::axisAt(const Vec3& place, const surface::AnySurface& drive) const {
  using Kind = runtime::ToolAxis::Kind;
  if (axisRule.kind != Kind::normalPart && axisRule.kind != Kind::normalDrive) {
    return axis;
  }
  const Named ps = partSurface();
  const Vec3 normal = footOn(axisRule.kind == Kind::normalPart ? ps.surface : drive, place).normal;
  return normal.dot(axis) < 0.0 ? Vec3(-normal) : normal;
}

}  // namespace arelem::certify
