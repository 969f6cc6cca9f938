// SPDX-License-Identifier: GPL-3.0-or-later
// What the page calls in its worker. Texts go in and come out; JSON comes out, with `error` where the program refuses.
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "brash/analysis/closed_forms.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/series.hpp"
#include "brash/simulator/session.hpp"

namespace brash::io {

/// A page has no netCDF. @throws InputError always.
Series read_netcdf_series(const std::string& path, const std::vector<double>& /*missing*/) {
  throw InputError(Complaint{path, "is netCDF, which the simulator in a page does not read", "a table as text (CSV)",
                             "write the table as CSV, or run the case with the command brash"});
}

}  // namespace brash::io

namespace {

std::optional<brash::simulator::Session> session;

/// What `act` gives, kept until the next call: the page copies it at once.
template <typename Act>
const char* said(Act act) {
  static std::string text;
  try {
    text = act();
  } catch (const std::exception& error) {
    text = nlohmann::json{{"error", error.what()}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  return text.c_str();
}

}  // namespace

extern "C" {

/// What `brash check` and `brash loads` say of a case: simulator::description(), and `loads`.
const char* brash_check(const char* toml, const char* name) {
  return said([&] {
    const brash::model::Case resolved = brash::io::parse_case(toml, name);
    auto all = nlohmann::ordered_json::parse(brash::simulator::description(resolved));
    all["loads"] = brash::analysis::closed_form_loads(resolved);
    return all.dump();
  });
}

/// Begins a simulation: `head` as Session::head(), `start` as Session::start(). The earlier one is gone, but it stays
/// if the text is not a case.
const char* brash_make(const char* toml, const char* name) {
  return said([&] {
    brash::model::Case resolved = brash::io::parse_case(toml, name);
    session.reset();  // a page has no memory for two
    session.emplace(std::move(resolved));
    return R"({"head":)" + session->head() + R"(,"start":)" + session->start() + "}";
  });
}

/// Makes `n_steps` steps: `records` as Session::advance(), `time` [s], and whether the case is `done`.
const char* brash_advance(int n_steps) {
  return said([&] {
    if (!session) throw brash::RunError("there is no simulation to continue\n  remedy:  begin one");
    const std::string records = session->advance(n_steps);
    return nlohmann::json{{"time", session->time()}, {"done", session->is_done()}}.dump().insert(
        1, R"("records":)" + records + ",");
  });
}

}  // extern "C"
