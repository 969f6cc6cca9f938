// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream.hpp"

#include "brash/core/contract.hpp"

namespace brash::live {

void Stream::publish(const std::string& event, const std::string& data) {
  BRASH_EXPECTS(data.find('\n') == std::string::npos, event);
  const std::scoped_lock lock(mutex_);
  events_.push_back(std::make_shared<const std::string>("id: " + std::to_string(events_.size()) + "\nevent: " + event +
                                                        "\ndata: " + data + "\n\n"));
}

void Stream::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
}

Stream::Event Stream::at(std::size_t index) const {
  const std::scoped_lock lock(mutex_);
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
  stream_.reader_left_.notify_all();
}

int Stream::n_readers() const {
  const std::scoped_lock lock(mutex_);
  return n_readers_;
}

void Stream::wait_for_readers(std::chrono::milliseconds longest) const {
  std::unique_lock lock(mutex_);
  reader_left_.wait_for(lock, longest, [&] { return n_readers_ == 0; });
}

}  // namespace brash::live
