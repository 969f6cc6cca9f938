// SPDX-License-Identifier: GPL-3.0-or-later
// Every broken case of tests/corpus/bad must end with an InputError that names all a user needs. Its file
// lists further texts that its message must contain, in lines `# expect: text`.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <regex>
#include <sstream>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "scratch.hpp"

namespace {

namespace fs = std::filesystem;

/// The broken cases as files in `folder`: the named blocks of cases.txt, and those that are no text.
std::vector<fs::path> corpus(const fs::path& folder) {
  const fs::path bad = BRASH_SOURCE_DIR "/tests/corpus/bad";
  fs::create_directories(folder);
  fs::copy(bad / "cases", folder);
  const std::string mark = "\n=== ", text = "\n" + read_bytes((bad / "cases.txt").string());
  for (std::size_t at = text.find(mark); at != std::string::npos;) {
    const std::size_t begin = at + mark.size(), line_end = text.find('\n', begin);
    at = text.find(mark, begin);
    const std::size_t end = at == std::string::npos ? text.size() - 1 : at;
    std::ofstream(folder / text.substr(begin, line_end - begin), std::ios::binary)
        << text.substr(line_end + 1, end - line_end - 1);
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> expectations(const fs::path& file) {
  const std::string mark = "# expect: ";
  std::istringstream stream(read_bytes(file.string()));
  std::vector<std::string> texts;
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(mark)) texts.push_back(line.substr(mark.size()));
  return texts;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_corpus)

BOOST_AUTO_TEST_CASE(every_broken_case_is_refused_with_all_that_a_user_needs) {
  const Scratch scratch;
  std::ofstream(scratch.path("units.txt"));  // a file outside, to which some cases lead
  const std::vector<fs::path> files = corpus(scratch.folder() / "bad/cases");
  BOOST_TEST(files.size() >= 180u);
  // place: key [= value]: the fault, then the allowed values and the remedy.
  const std::regex shape(
      "^[^\n]*\\.toml:[0-9]+:[0-9]+: [^\n]+: [^\n]+\n  allowed: [^\n]+\n(  nearest: [^\n]+\n)?  remedy:  [^\n]+");
  for (const fs::path& file : files) {
    std::string message;
    try {
      brash::io::read_case(file.string());
    } catch (const brash::InputError& error) {
      message = error.what();
    }
    BOOST_TEST(!message.empty(), file.filename() << " is not refused");
    BOOST_TEST(std::regex_search(message, shape), file.filename() << " has a message of another shape:\n" << message);
    // A message goes to a terminal: the text of a file may not steer it.
    BOOST_TEST(std::none_of(message.begin(), message.end(), [](char c) { return c != '\n' && c >= 0 && c < 0x20; }));
    const std::vector<std::string> texts = expectations(file);
    BOOST_TEST(!texts.empty(), file.filename() << " expects nothing");
    for (const std::string& text : texts)
      BOOST_TEST(message.find(text) != std::string::npos, file.filename() << ": \"" << text << "\" is not in\n"
                                                                          << message);
  }
}

BOOST_AUTO_TEST_SUITE_END()
