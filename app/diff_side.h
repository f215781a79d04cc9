#pragma once
#include <condition_variable>
#include <deque>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/cl_input.h"
#include "app/cl_moves.h"

namespace arelem::app {

/// Batches of moves on their way from the thread that reads a file to the one that compares. Few
/// are on the way: the reader waits.
class MoveChannel {
 public:
  void push(std::vector<ClMove> moves);
  /// Nothing more comes.
  void close();
  /// The next batch; false at the end.
  [[nodiscard]] bool pop(std::vector<ClMove>& moves);

 private:
  static constexpr std::size_t most = 4;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::vector<ClMove>> batches_;
  bool closed_ = false;
};

/// How a file is read for a comparison.
struct DiffReading {
  bool withWords = false;
  bool inPieces = true;
};

/// One of two files that are compared: it is read in a thread of its own, as far as it is looked
/// at.
class DiffSide {
 public:
  DiffSide(const Settings& settings,
           const std::string& path,
           DiffReading how,
           const InterruptFlag& interrupted);
  ~DiffSide();
  DiffSide(const DiffSide&) = delete;
  DiffSide& operator=(const DiffSide&) = delete;

  /// The move that is `ahead` moves behind the next one; null at the end of the file.
  [[nodiscard]] const ClMove* peek(std::size_t ahead = 0);
  void skip(std::size_t count);
  /// The number of the next move, from 0; at the end that of all moves.
  [[nodiscard]] std::size_t index() const { return index_; }
  /// Passes over what is left.
  void drain();
  /// The same, and ends the reading. False after an error, which is in the log.
  bool finish();

  /// The file could not be read in pieces, and moves of pieces were compared: all of it is void.
  /// Behind `finish`.
  [[nodiscard]] bool stale() const { return stale_; }

  [[nodiscard]] const std::string& name() const { return name_; }
  /// "a.cls:12" or, without lines, the statement number. Behind `finish`.
  [[nodiscard]] std::string place(const ClMove& move) const;
  [[nodiscard]] DiagnosticLog& log() { return read_.job->log; }
  [[nodiscard]] const Compilation& job() const { return *read_.job; }
  /// Words for the machine behind the last move. Behind `finish`.
  [[nodiscard]] const std::string& wordsBehind() const { return wordsBehind_; }

 private:
  class Sender;
  std::string name_;
  MoveChannel channel_;
  std::unique_ptr<Sender> sender_;
  ReadFile read_;
  std::string wordsBehind_;
  std::deque<ClMove> window_;
  std::size_t index_ = 0;
  bool stale_ = false, inPieces_ = false;
  std::future<void> reading_;
};

}  // namespace arelem::app
