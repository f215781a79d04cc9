#include "backend/joints/writer.h"

#include <cmath>
#include <ostream>

#include "backend/joints/plot.h"
#include "backend/joints/table.h"
#include "ir/diag/render_text.h"
#include "ir/diag/robot.h"

namespace arelem::backend {

namespace {
using namespace joints;

/// Numbers of the table: enough digits for a controller, never "-0".
std::string number(double value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  const double rounded = std::round(value * unit) / unit;
  return fmt::format("{:.{}f}", rounded == 0.0 ? 0.0 : rounded, decimals);
}

void writeHead(std::ostream& out, const Arm& arm, const robot::Machine& machine) {
  const std::string_view first = arm.jointName(0);
  const std::string_view unit = arm.unit(0);
  out << "index,time_s,gun," << first << '_' << unit << ",turn_deg," << first << '_' << unit
      << "_s,turn_deg_s," << first << '_' << unit << "_s2,turn_deg_s2";
  for (std::size_t j = 0; j < 2; ++j) {
    if (arm.counts(j) > 0.0) {
      out << ',' << arm.jointName(j) << "_counts";
    }
  }
  out << ",x_mm,y_mm,z_mm,heading_deg,tilt_deg" << (machine.tilt ? ",tilt_word" : "") << '\n';
}

void writeRow(std::ostream& out,
              std::size_t index,
              const Row& row,
              const Arm& arm,
              const robot::Machine& machine) {
  constexpr int places = 6;
  constexpr int rates = 4;
  constexpr int tool = 3;
  out << index << ',' << number(row.time, places) << ',' << (row.tool.gun ? 1 : 0);
  for (std::size_t j = 0; j < 2; ++j) {
    out << ',' << number(row.joints.place[j], places);
  }
  for (const auto& rate : {row.joints.speed, row.joints.acceleration}) {
    out << ',' << number(rate[0], rates) << ',' << number(rate[1], rates);
  }
  for (std::size_t j = 0; j < 2; ++j) {
    if (arm.counts(j) > 0.0) {
      out << ',' << std::llround(row.joints.place[j] * arm.counts(j));
    }
  }
  for (Eigen::Index k = 0; k < row.tool.place.size(); ++k) {
    out << ',' << number(row.tool.place[k], tool);
  }
  if (machine.tilt) {
    out << ',' << tiltWord(*machine.tilt, row.tool.place[4]);
  }
  out << '\n';
}

/// Keeps the locations of the records; at the end the motion is planned and written.
class JointWriter : public Writer {
 public:
  enum class Kind : std::uint8_t { table, plot };

  JointWriter(std::ostream& out, const Context& context, DiagnosticSink& sink, Kind kind)
      : out_(out), sink_(sink), kind_(kind) {
    if (context.machine != nullptr) {
      machine_ = *context.machine;
    }
  }

  void accept(const cl::Record& record) override { reader_.accept(record); }

  void finish() override {
    if (machine_.pantograph.has_value() == machine_.elbow.has_value()) {
      sink_.accept(diagnose(
          nowhere, diag::JointsMachine,
          machine_.file.empty() ? std::string("no machine file") : "`" + machine_.file + "`",
          machine_.pantograph ? std::string_view("both") : "none"));
      return;
    }
    const Arm arm(machine_);
    reader_.finish();
    if (reader_.failed() || !canFollow(arm, reader_.knots(), machine_.speed, sink_)) {
      return;
    }
    Table table;
    if (!reader_.knots().empty()) {
      table = tableOf(arm, reader_.knots(), machine_, sink_);
    }
    if (kind_ == Kind::plot) {
      writePlot(out_, arm, table);
    } else {
      writeHead(out_, arm, machine_);
      for (std::size_t i = 0; i < table.rows.size(); ++i) {
        writeRow(out_, i, table.rows[i], arm, machine_);
      }
    }
    out_.flush();
  }

 private:
  std::ostream& out_;
  DiagnosticSink& sink_;
  Kind kind_;
  robot::Machine machine_;
  KnotReader reader_{machine_, sink_};
};
}  // namespace

std::unique_ptr<Writer> makeJointTableWriter(std::ostream& out,
                                             const Context& context,
                                             DiagnosticSink& sink) {
  return std::make_unique<JointWriter>(out, context, sink, JointWriter::Kind::table);
}

std::unique_ptr<Writer> makeJointPlotWriter(std::ostream& out,
                                            const Context& context,
                                            DiagnosticSink& sink) {
  return std::make_unique<JointWriter>(out, context, sink, JointWriter::Kind::plot);
}

}  // namespace arelem::backend
