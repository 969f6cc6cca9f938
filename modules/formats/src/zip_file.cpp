// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/formats/zip_file.hpp"

#include <zip.h>
#include <zlib.h>

#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"

namespace brash::formats {
namespace {

namespace fs = std::filesystem;

/// The first day that the format knows, and the rights of a file that everybody reads.
zip_fileinfo info_of_all() {
  zip_fileinfo info{};
  info.tmz_date = {.tm_sec = 0, .tm_min = 0, .tm_hour = 0, .tm_mday = 1, .tm_mon = 0, .tm_year = 1980};
  info.external_fa = 0100644UL << 16;
  return info;
}

bool add(zipFile archive, const ZipEntry& entry) {
  const zip_fileinfo info = info_of_all();
  return zipOpenNewFileInZip(archive, entry.path.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                             Z_DEFAULT_COMPRESSION) == ZIP_OK &&
         zipWriteInFileInZip(archive, entry.bytes.data(), static_cast<unsigned>(entry.bytes.size())) == ZIP_OK &&
         zipCloseFileInZip(archive) == ZIP_OK;
}

}  // namespace

void write_zip(const std::string& path, const std::vector<ZipEntry>& entries) {
  if (const fs::path folder = fs::path(path).parent_path(); !folder.empty()) {
    std::error_code ignored;  // a folder that cannot be made is one that the file cannot be opened in
    fs::create_directories(folder, ignored);
  }
  const std::string part = part_of(path);
  std::error_code gone;
  fs::remove(part, gone);  // a file that is there is never opened
  const zipFile archive = zipOpen(part.c_str(), APPEND_STATUS_CREATE);
  bool written = archive != nullptr;
  for (const ZipEntry& entry : entries) written = written && add(archive, entry);
  if (archive != nullptr) written = zipClose(archive, nullptr) == ZIP_OK && written;
  if (!written) {
    fs::remove(part, gone);
    throw StorageError(path + ": cannot be written\n  remedy:  check that its folder may be written, and its disk");
  }
  publish(part, path);
}

}  // namespace brash::formats
