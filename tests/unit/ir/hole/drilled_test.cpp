// The holes of cycles move by move, for pictures.
#include "ir/hole/drilled.h"

#include <gtest/gtest.h>

namespace arelem::hole {
namespace {

class Seen : public cl::RecordSink {
 public:
  void accept(const cl::Record& record) override {
    if (const auto* post = std::get_if<cl::Post>(&record.body)) {
      text += std::string(spell(post->word)) + " ";
      if (!post->arguments.empty() && std::holds_alternative<double>(post->arguments[0])) {
        text += std::to_string(static_cast<int>(std::get<double>(post->arguments[0]))) + " ";
      }
    } else if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      text += motion->kind == cl::Motion::Kind::continuation ? "and" : "go";
      for (const double v : motion->coordinates) {
        text += " " + std::to_string(static_cast<int>(v));
      }
      text += "; ";
    }
  }
  std::string text;
};

cl::Record record(cl::Body body) {
  cl::Record r;
  r.body = std::move(body);
  return r;
}

cl::Record go(std::vector<double> coordinates) {
  cl::Motion motion;
  motion.coordinates = std::move(coordinates);
  return record(motion);
}

TEST(Drilled, OverTheHoleDownAndUpAgain) {
  Seen seen;
  Drilled drilled(seen);
  drilled.accept(record(cl::Post{Word::FEDRAT, "", {60.0}}));
  drilled.accept(go({0, 0, 50}));
  drilled.accept(record(cl::Post{Word::CYCLE, "", {Word::DRILL, 30.0, 40.0, Word::MMPM, 2.0}}));
  drilled.accept(go({10, 0, 0}));
  drilled.accept(record(cl::Post{Word::CYCLE, "", {Word::OFF}}));
  drilled.accept(go({0, 0, 50}));
  EXPECT_EQ(seen.text,
            "FEDRAT 60 go 0 0 50; RAPID go 10 0 50; RAPID and 10 0 2; FEDRAT 40 and 10 0 -30; "
            "RAPID and 10 0 2; FEDRAT 60 go 0 0 50; ");
}

TEST(Drilled, WhatIsNoKnownHoleGoesOnAsItIs) {
  Seen seen;
  Drilled drilled(seen);
  drilled.accept(go({0, 0, 50}));
  drilled.accept(record(cl::Post{Word::CYCLE, "", {Word::CAM, 3.0}}));
  drilled.accept(go({10, 0, 0}));
  drilled.accept(record(cl::Post{Word::CYCLE, "", {Word::OFF}}));
  EXPECT_EQ(seen.text, "go 0 0 50; CYCLE go 10 0 0; CYCLE ");
}

}  // namespace
}  // namespace arelem::hole
