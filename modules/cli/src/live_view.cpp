// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_view.hpp"

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "brash/recording/recording.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "runs.hpp"

namespace brash::cli {
namespace {

/// Frames of less time go together: each sending wakes the threads of all browsers.
constexpr std::chrono::milliseconds kBetween{100};
/// Time that browsers have to take the end of a run.
constexpr std::chrono::seconds kFarewell{5};

}  // namespace

LiveView::LiveView(const model::Case& resolved)
    : server_(report::live_page(resolved, simulation::land_outlines(resolved))), records_(resolved) {}

void LiveView::watch(simulation::RunOptions& options) {
  if (options.checkpoint.newest)
    options.checkpoint.newest = [this, store = options.checkpoint, newest = std::move(options.checkpoint.newest)] {
      std::optional<model::Checkpoint> saved = newest();
      if (saved) {
        records_.begin_with(recording::with_earlier(store, saved->results));
        waits_ = true;
      }
      return saved;
    };
  options.observer = [this, observer = std::move(options.observer)](const simulation::Simulation& simulation,
                                                                    const simulation::StepReport& report) {
    if (observer) observer(simulation, report);
    waits_ |= records_.take(simulation, report);
    if (waits_ && std::chrono::steady_clock::now() - sent_ >= kBetween) send_rest();
  };
  options.interrupted = [this, interrupted = std::move(options.interrupted)] {
    // A browser may come during a pause.
    server_.wait_while_paused([this] {
      send_rest();
      return is_asked_to_end();
    });
    return (interrupted && interrupted()) || server_.is_asked_to_end();
  };
}

void LiveView::send() {
  server_.publish("records", records_.next());
  sent_ = std::chrono::steady_clock::now();
  waits_ = false;
}

void LiveView::send_rest() {
  if (waits_ && server_.is_watched()) send();
}

void LiveView::end(const std::string& text) {
  send_rest();
  server_.publish("end", nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  server_.finish(kFarewell);
}

}  // namespace brash::cli
