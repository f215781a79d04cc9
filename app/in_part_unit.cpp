#include "app/in_part_unit.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/verify.h"
#include "ir/words/units.h"

namespace arelem::app {

namespace {
/// Files round; diameters and corner radii that differ by this share of the diameter are the same.
constexpr double sameCutter = 1e-4;
constexpr std::size_t circleValues = 7;  // center, axis, radius

/// CUTTER/d, d,r or d,r,e,f,alpha,beta,h; three values are a ring of CUTTER/OPTION.
bool isTool(const cl::Values& v) {
  return v.word == Word::CUTTER &&
         (v.values.size() == 1 || v.values.size() == 2 || v.values.size() == 7);
}
double radiusOf(const std::vector<double>& cutter) {
  return cutter.size() > 1 ? cutter[1] : 0.0;
}
}  // namespace

PartFacts partFactsOf(const std::vector<runtime::Action>& actions) {
  PartFacts facts;
  for (const runtime::Action& action : actions) {
    if (const auto* pass = std::get_if<runtime::Pass>(&action.body)) {
      const auto* units = std::get_if<cl::Units>(&pass->body);
      if (units != nullptr && !facts.millimeters) {
        facts.millimeters = millimetersOf(units->unit);
      }
    } else if (const auto* set = std::get_if<runtime::Parameter>(&action.body)) {
      if (cl::Values cutter{set->word, set->values}; isTool(cutter)) {
        facts.cutters.push_back(std::move(cutter));
      }
    }
  }
  return facts;
}

void InPartUnit::accept(const cl::Record& record) {
  if (const auto* units = std::get_if<cl::Units>(&record.body)) {
    takeUnit(record, *units);
  } else if (const auto* values = std::get_if<cl::Values>(&record.body);
             values != nullptr && isTool(*values)) {
    takeCutter(record, *values);
  }
  if (factor_ == 1.0) {
    return next_.accept(record);
  }
  cl::Record scaled = record;
  scale(scaled.body);
  next_.accept(scaled);
}

void InPartUnit::takeUnit(const cl::Record& record, const cl::Units& units) {
  if (part_.millimeters) {
    factor_ = millimetersOf(units.unit) / *part_.millimeters;
  } else if (!told_) {
    sink_.accept(diagnose(record.origin, diag::UnitOfFile, file_, spell(units.unit)));
    told_ = true;
  }
}

void InPartUnit::takeCutter(const cl::Record& record, const cl::Values& cutter) {
  const double diameter = factor_ * cutter.values[0];
  const double radius = factor_ * radiusOf(cutter.values);
  const double near = sameCutter * std::abs(diameter);
  const bool known =
      std::any_of(part_.cutters.begin(), part_.cutters.end(), [&](const cl::Values& own) {
        return std::abs(own.values[0] - diameter) <= near &&
               std::abs(radiusOf(own.values) - radius) <= near;
      });
  if (!known && !part_.cutters.empty()) {
    sink_.accept(diagnose(record.origin, diag::CutterOfFile, file_, diameter, radius));
  }
}

void InPartUnit::scale(cl::Body& body) const {
  if (auto* motion = std::get_if<cl::Motion>(&body)) {
    for (std::size_t i = 0; i + motion->stride() <= motion->coordinates.size();
         i += motion->stride()) {
      for (std::size_t k = i; k < i + 3; ++k) {
        motion->coordinates[k] *= factor_;
      }
    }
  } else if (auto* values = std::get_if<cl::Values>(&body);
             values != nullptr && values->word != Word::CUTTER) {
    for (double& v : values->values) {
      v *= factor_;
    }
  } else if (auto* surface = std::get_if<cl::Surface>(&body);
             surface != nullptr && surface->surface.canon.size() == circleValues) {
    for (const std::size_t k : {0U, 1U, 2U, 6U}) {
      surface->surface.canon[k] *= factor_;
    }
  } else if (auto* post = std::get_if<cl::Post>(&body);
             post != nullptr && post->foreign == "CNTRL") {
    for (cl::Value& v : post->arguments) {
      if (double* number = std::get_if<double>(&v)) {
        *number *= factor_;
      }
    }
  }
}

}  // namespace arelem::app
