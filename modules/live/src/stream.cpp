// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream.hpp"

#include "brash/core/contract.hpp"

namespace brash::live {

void Stream::publish(const std::string& event, const std::string& data) {
  BRASH_EXPECTS(data.find('\n') == std::string::npos, event);
  const std::scoped_lock lock(mutex_);
  events_.push_back(std::make_shared<const std::string>("id: " + std::to_string(events_.size()) + "\nevent: " + event +
                                                        "\ndata: " + data + "\n\n"));
  changed_.notify_all();
}

void Stream::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

Stream::Event Stream::wait_for(std::size_t index, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [&] { return index < events_.size() || closed_; });
  return index < events_.size() ? events_[index] : nullptr;
}

bool Stream::ends_before(std::size_t index) const {
  const std::scoped_lock lock(mutex_);
  return closed_ && index >= events_.size();
}

Stream::Reader::Reader(Stream& stream) : stream_(stream) {
  const std::scoped_lock lock(stream_.mutex_);
  ++stream_.n_readers_;
}

Stream::Reader::~Reader() {
  const std::scoped_lock lock(stream_.mutex_);
  --stream_.n_readers_;
  stream_.changed_.notify_all();
}

int Stream::n_readers() const {
  const std::scoped_lock lock(mutex_);
  return n_readers_;
}

void Stream::wait_for_readers(std::chrono::milliseconds longest) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, longest, [&] { return n_readers_ == 0; });
}

}  // namespace brash::live
