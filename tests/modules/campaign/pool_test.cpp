// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/campaign/pool.hpp"

#include <signal.h>

#include <boost/test/unit_test.hpp>
#include <thread>

#include "brash/core/error.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::campaign;

namespace {

/// A job that runs a line of the shell.
Job shell(const Scratch& scratch, const std::string& name, const std::string& line) {
  return {.command = {"/bin/sh", "-c", line},
          .messages = scratch.path(name + ".messages"),
          .folder = scratch.path(name + ".part"),
          .result = scratch.path(name),
          .record = scratch.path(name + ".failed")};
}

bool exists(const Scratch& scratch, const std::string& name) { return std::filesystem::exists(scratch.path(name)); }

}  // namespace

BOOST_AUTO_TEST_SUITE(pool)

BOOST_AUTO_TEST_CASE(every_job_runs_and_no_more_than_the_workers_at_once) {
  const Scratch scratch;
  std::vector<Job> jobs;
  for (int i = 0; i < 12; ++i) {
    jobs.push_back(
        shell(scratch, std::to_string(i),
              "mkdir running.$$; ls -d running.* | wc -l > \"$0.count\"; sleep 0.02; rmdir running.$$; touch \"$0\""));
    jobs.back().command.push_back(jobs.back().result);
  }
  std::filesystem::current_path(scratch.folder());
  BOOST_TEST(run_jobs(3, jobs));
  for (int i = 0; i < 12; ++i) {
    BOOST_TEST(exists(scratch, std::to_string(i)));
    const int at_once = std::stoi(read_bytes(scratch.path(std::to_string(i) + ".count")));
    BOOST_TEST((at_once >= 1 && at_once <= 3), at_once);
  }
  std::filesystem::current_path("/");
}

BOOST_AUTO_TEST_CASE(a_job_that_fails_by_itself_leaves_a_record_and_the_others_go_on) {
  const Scratch scratch;
  BOOST_TEST(run_jobs(1, {shell(scratch, "a", "echo 'the ledger does not close' >&2; exit 1"),
                          shell(scratch, "b", "kill -SEGV $$"), shell(scratch, "c", "exit 0")}));
  const std::string a = read_bytes(scratch.path("a.failed"));
  BOOST_TEST(a.find("\"error\": \"the ledger does not close\"") != std::string::npos, a);
  BOOST_TEST(a.find("\"exit_code\": 1") != std::string::npos, a);
  BOOST_TEST(read_bytes(scratch.path("b.failed")).find("\"signal\": \"SEGV\"") != std::string::npos);
  BOOST_TEST(!exists(scratch, "c.failed"));
  for (const char* const left : {"a.part", "a.messages", "b.messages", "c.messages"})
    BOOST_TEST(!exists(scratch, left));
}

BOOST_AUTO_TEST_CASE(a_job_that_is_killed_from_outside_or_interrupted_has_no_record) {
  const Scratch scratch;
  BOOST_TEST(run_jobs(
      2, {shell(scratch, "a", "kill -KILL $$"), shell(scratch, "b", "kill -TERM $$"), shell(scratch, "c", "exit 3")}));
  for (const char* const name : {"a.failed", "b.failed", "c.failed"}) BOOST_TEST(!exists(scratch, name));
}

BOOST_AUTO_TEST_CASE(a_job_whose_result_or_record_is_there_is_not_run_again) {
  const Scratch scratch;
  scratch.write("a", "");
  scratch.write("b.failed", "");
  BOOST_TEST(run_jobs(1, {shell(scratch, "a", "exit 1"), shell(scratch, "b", "touch \"$0\"")}));
  BOOST_TEST(!exists(scratch, "a.failed"));
  BOOST_TEST(!exists(scratch, "b.part"));
}

BOOST_AUTO_TEST_CASE(a_disk_that_is_full_stops_the_pool_instead_of_failing_every_job) {
  const Scratch scratch;
  const std::vector<Job> jobs{shell(scratch, "a", "echo 'no space left' >&2; exit 4"),
                              shell(scratch, "b", "touch b-has-run")};
  BOOST_CHECK_EXCEPTION(run_jobs(1, jobs), StorageError,
                        [](const StorageError& error) { return std::string(error.what()) == "no space left"; });
  BOOST_TEST(!exists(scratch, "a.failed"));
}

BOOST_AUTO_TEST_CASE(an_interruption_reaches_the_processes_and_no_job_is_started_after_it) {
  const Scratch scratch;
  std::vector<Job> jobs;
  for (const char* const name : {"a", "b", "c"})
    jobs.push_back(shell(scratch, name, "trap 'exit 3' TERM; touch \"$0\"; while :; do sleep 0.01; done"));
  for (Job& job : jobs) job.command.push_back(job.result + ".started");
  // The signal comes when two are running; this process takes it in the pool.
  std::thread other([&] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    while (!exists(scratch, "a.started") || !exists(scratch, "b.started"))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(getpid(), SIGINT);
  });
  BOOST_TEST(!run_jobs(2, jobs));
  other.join();
  BOOST_TEST(!exists(scratch, "c.started"));
  BOOST_TEST(!exists(scratch, "a.failed"));
}

BOOST_AUTO_TEST_CASE(a_program_that_is_not_there_is_an_error) {
  const Scratch scratch;
  Job job = shell(scratch, "a", "");
  job.command = {scratch.path("nothing")};
  BOOST_CHECK_THROW(run_jobs(1, {job}), RunError);
}

BOOST_AUTO_TEST_SUITE_END()
