#include "app/diff_side.h"

#include "app/source_file.h"

namespace arelem::app {

void MoveChannel::push(std::vector<ClMove> moves) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return batches_.size() < most; });
  batches_.push_back(std::move(moves));
  changed_.notify_all();
}

void MoveChannel::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

bool MoveChannel::pop(std::vector<ClMove>& moves) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return closed_ || !batches_.empty(); });
  if (batches_.empty()) {
    return false;
  }
  moves = std::move(batches_.front());
  batches_.pop_front();
  changed_.notify_all();
  return true;
}

/// Sends the moves of a reading.
class DiffSide::Sender : public cl::RecordSink {
 public:
  Sender(MoveChannel& channel, ClMoves::LineOf lineOf, bool withWords)
      : channel_(channel), moves_(std::move(lineOf), withWords) {}

  void accept(const cl::Record& record) override {
    moves_.accept(record);
    if (moves_.ended()) {
      send();
    }
  }
  void send() {
    sent_ = true;
    channel_.push(moves_.take());
  }
  [[nodiscard]] bool sent() const { return sent_; }
  [[nodiscard]] const std::string& wordsBehind() const { return moves_.wordsBehind(); }

 private:
  MoveChannel& channel_;
  ClMoves moves_;
  bool sent_ = false;
};

namespace {
/// Closes a channel however the reading ends.
class Closer {
 public:
  explicit Closer(MoveChannel& channel) : channel_(channel) {}
  ~Closer() { channel_.close(); }
  Closer(const Closer&) = delete;
  Closer& operator=(const Closer&) = delete;

 private:
  MoveChannel& channel_;
};
}  // namespace

DiffSide::DiffSide(const Settings& settings,
                   const std::string& path,
                   DiffReading how,
                   const InterruptFlag& interrupted)
    : name_(displayName(path)) {
  reading_ = std::async(std::launch::async, [this, &settings, path, how, &interrupted] {
    const Closer closer(channel_);
    const auto begin = [&](Compilation& job, const ClTexts* texts) -> cl::RecordSink* {
      stale_ = sender_ != nullptr && sender_->sent();
      inPieces_ = texts != nullptr;
      const auto lineOf = [&job, texts](const Span& at) {
        return texts != nullptr                       ? texts->line(at)
               : at.buffer.index < job.sources.size() ? job.sources.locate(at.buffer, at.begin).line
                                                      : 0;
      };
      sender_ = stale_ ? nullptr : std::make_unique<Sender>(channel_, lineOf, how.withWords);
      return sender_.get();
    };
    read_ = readFile(settings, path, begin, interrupted, how.inPieces);
    if (sender_) {
      sender_->send();
      wordsBehind_ = sender_->wordsBehind();
    }
  });
}

DiffSide::~DiffSide() {
  std::vector<ClMove> moves;
  while (channel_.pop(moves)) {
  }
}

const ClMove* DiffSide::peek(std::size_t ahead) {
  std::vector<ClMove> moves;
  while (window_.size() <= ahead && channel_.pop(moves)) {
    window_.insert(window_.end(), std::make_move_iterator(moves.begin()),
                   std::make_move_iterator(moves.end()));
  }
  return ahead < window_.size() ? &window_[ahead] : nullptr;
}

void DiffSide::skip(std::size_t count) {
  window_.erase(window_.begin(), window_.begin() + static_cast<std::ptrdiff_t>(count));
  index_ += count;
}

void DiffSide::drain() {
  while (peek() != nullptr) {
    skip(window_.size());
  }
}

bool DiffSide::finish() {
  drain();
  reading_.get();
  return read_.whole && read_.job->log.errors() == 0;
}

std::string DiffSide::place(const ClMove& move) const {
  if (move.line == 0) {
    return fmt::format("{} statement {}", name_, move.isn);
  }
  const SourceMap& sources = read_.job->sources;
  const bool other = !inPieces_ && move.text < sources.size();
  return fmt::format("{}:{}", other ? sources.name({move.text}) : name_, move.line);
}

}  // namespace arelem::app
