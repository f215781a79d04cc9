#include "tests/fuzz/targets.h"

#include <array>
#include <sstream>

#include "backend/backend.h"
#include "backend/cltape/codes.h"
#include "backend/cltape/dump.h"
#include "backend/cltape/reader.h"
#include "backend/g97/block.h"
#include "backend/json/reader.h"
#include "backend/robot/machine.h"
#include "backend/vplus/reader.h"
#include "frontend/compile.h"
#include "runtime/geometry/mesh_file.h"
#include "runtime/path/frame_stage.h"
#include "runtime/path/movnrb.h"
#include "runtime/region/drawing.h"
#include "runtime/run.h"
#include "runtime/spray/calibration.h"
#include "runtime/stencil/alphabet.h"
#include "tests/fuzz/pieces.h"

namespace arelem::fuzz {

namespace {
class Silence : public DiagnosticSink {
 public:
  void accept(Diagnostic diagnostic) override {
    length_ += diagnostic.message.size();  // the text is made, as a user would see it
    errors_ = errors_ || diagnostic.severity() == Severity::error;
  }
  [[nodiscard]] bool errors() const { return errors_; }

 private:
  std::size_t length_ = 0;
  bool errors_ = false;
};

Limits smallLimits() {
  Limits limits;
  limits.steps = 5000;
  limits.depth = 20;
  limits.records = 20'000;
  limits.elements = 5000;
  limits.points = 1000;
  limits.array = 10'000;
  return limits;
}

frontend::Options optionsFor(const std::string& text) {
  frontend::Options options;
  options.dialect = static_cast<frontend::Dialect>(text.size() % frontend::dialectCount);
  options.limits = smallLimits();
  return options;
}

/// Cards, columns, tokens, parser and checks of the frontend. The dialect follows from the length.
void readText(const std::string& text) {
  SourceMap sources;
  Silence silence;
  const BufferId buffer = sources.add("fuzz.apt", text);
  const ir::Program program = frontend::compile(sources, buffer, optionsFor(text), silence);
  std::ostringstream out;
  ir::print(out, program);
  ir::FeatureCounts counts;
  ir::survey(program, counts);
}

runtime::Options runOf(const frontend::Options& options) {
  runtime::Options run;
  run.limits = options.limits;
  return run;
}

/// The same, then Section 1 with small limits.
void wholeProgram(const std::string& text) {
  SourceMap sources;
  Silence silence;
  const BufferId buffer = sources.add("fuzz.apt", text);
  const frontend::Options options = optionsFor(text);
  const ir::Program program = frontend::compile(sources, buffer, options, silence);
  const runtime::Evaluation evaluation = runtime::evaluate(program, runOf(options), silence);
  static_cast<void>(evaluation);
}

void tape(const std::string& bytes) {
  Silence silence;
  cl::Recording records;
  std::istringstream in(bytes);
  backend::readTape(in, records, silence, smallLimits());
  std::istringstream again(bytes);
  std::ostringstream out;
  backend::dump(again, out, silence, smallLimits());
  // What was read can be written.
  const auto writer = backend::findTarget("cltape")->make(out, {}, silence);
  for (const cl::Record& record : records.records) {
    writer->accept(record);
  }
  writer->finish();
}

/// CL text of a CAM system on its way to the records.
void clText(const std::string& text) {
  SourceMap sources;
  Silence silence;
  const BufferId buffer = sources.add("fuzz.cls", text);
  frontend::Options options = optionsFor(text);
  options.dialect = frontend::Dialect::cl;
  const ir::Program program = frontend::compile(sources, buffer, options, silence);
  runtime::Options run = runOf(options);
  const runtime::Evaluation evaluation = runtime::evaluate(program, run, silence);
  cl::Recording records;
  const auto frames = path::makeFrameStage(
      records, text.size() % 2 == 0 ? path::Frames::part : path::Frames::asWritten, silence);
  const auto splines = path::makeMovnrbCheck(*frames, silence);
  run.axesFollow = true;
  static_cast<void>(runtime::execute(evaluation.actions, run, *splines, silence));
}

void json(const std::string& bytes) {
  Silence silence;
  cl::Recording records;
  std::istringstream in(bytes);
  static_cast<void>(backend::readJsonRecords(in, "fuzz.json", records, silence));
}

void drawing(const std::string& bytes) {
  region::DrawingRules rules;
  rules.mostPoints = 100'000;
  if (auto read = region::readDrawing(bytes, "fuzz.dxf", rules); read) {
    const auto loops = region::chained(std::move(read->curves), "fuzz.dxf", 1e-3);
    std::vector<region::Boundary> boundaries;
    for (std::size_t i = 0; loops && i < loops->size(); ++i) {
      region::Boundary& boundary = boundaries.emplace_back();
      boundary.role = region::Boundary::Role::byPlace;
      for (const auto& place : (*loops)[i]) {
        boundary.corners.emplace_back(place.x(), place.y(), read->height);
      }
    }
    if (!boundaries.empty()) {
      static_cast<void>(region::regionOf(std::move(boundaries)));
    }
  }
}

void mesh(const std::string& bytes) {
  for (const auto format : {geometry::MeshFormat::stl, geometry::MeshFormat::obj,
                            geometry::MeshFormat::ply, geometry::MeshFormat::off}) {
    static_cast<void>(geometry::readMesh(bytes, format, "fuzz.mesh"));
  }
}

void tables(const std::string& bytes) {
  static_cast<void>(robot::readMachine(bytes, "fuzz.toml"));
  static_cast<void>(backend::tape::Codes::read(bytes, "fuzz.toml"));
  static_cast<void>(spray::readCalibration(bytes, "fuzz.toml"));
}

void alphabet(const std::string& bytes) {
  static_cast<void>(stencil::readAlphabet(bytes, "fuzz.alphabet"));
}

void g97(const std::string& bytes) {
  static_cast<void>(g97::readPrograms(bytes, {}, "fuzz.lng"));
}

void vplus(const std::string& bytes) {
  static_cast<void>(vplus::readProgram(bytes, "fuzz.v2", nullptr));
}

const std::array table = {
    Target{"reader", readText, {".apt"}},
    Target{"program", wholeProgram, {".apt"}},
    Target{"cl", clText, {".cls", ".apt"}},
    Target{"pieces", inPieces, {".cls"}},
    Target{"tape", tape, {".apt"}, "cltape"},
    Target{"json", json, {".apt"}, "json"},
    Target{"drawing", drawing, {".dxf"}},
    Target{"mesh", mesh, {".stl", ".obj", ".ply", ".off"}},
    Target{"tables", tables, {".toml"}},
    Target{"alphabet", alphabet, {".alphabet"}},
    Target{"g97", g97, {".apt"}, "g97"},
    Target{"vplus", vplus, {".apt"}, "vplus"},
};
}  // namespace

std::span<const Target> targets() {
  return table;
}

std::string compiled(const std::string& program, std::string_view format) {
  SourceMap sources;
  Silence silence;
  const BufferId buffer = sources.add("seed.apt", program);
  frontend::Options options;
  options.limits = smallLimits();
  const ir::Program read = frontend::compile(sources, buffer, options, silence);
  const runtime::Options run = runOf(options);
  const runtime::Evaluation evaluation = runtime::evaluate(read, run, silence);
  std::ostringstream out;
  const auto writer = backend::findTarget(format)->make(out, {}, silence);
  static_cast<void>(runtime::execute(evaluation.actions, run, *writer, silence));
  writer->finish();
  return silence.errors() ? "" : std::move(out).str();
}

}  // namespace arelem::fuzz
