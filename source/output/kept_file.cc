// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/kept_file.h>
#include <ringmotor/version.h>

#include <zlib.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace ringmotor
{
  namespace
  {
    // The file: this line, a line with the checksum of all that follows it, the key with its length
    // before it, and the content.
    const std::string first_line = "ringmotor, kept for a later run, with checksum\n";

    /** Eight digits that differ if a few bits do (CRC-32). There may be a gigabyte of bytes. */
    std::string checksum(const std::string_view bytes)
    {
      char digits[9];
      const auto *const begin = reinterpret_cast<const unsigned char *>(bytes.data());
      std::snprintf(digits, sizeof(digits), "%08lx", crc32_z(0, begin, bytes.size()));
      return digits;
    }

    std::string head_of(const std::string &key)
    {
      return std::to_string(key.size()) + "\n" + key;
    }
  } // namespace

  std::string this_build()
  {
    // Version and revision do not show later changes or how the program was compiled.
    const std::filesystem::path program = "/proc/self/exe";
    return std::string("ringmotor ") + version + " (" + git_revision + "), executable of " +
           std::to_string(std::filesystem::file_size(program)) + " bytes, linked at " +
           std::to_string(std::filesystem::last_write_time(program).time_since_epoch().count()) +
           "\n";
  }

  void write_kept_file(const std::string &path, const std::string &key, const std::string &bytes)
  {
    // The checksum replaces one of the same length in place: there may be many bytes.
    const std::string blank = checksum("");
    std::string file        = first_line + blank + "\n" + head_of(key);
    file += bytes;
    const std::size_t begin = first_line.size(), after = begin + blank.size() + 1;
    file.replace(begin, blank.size(), checksum(std::string_view(file).substr(after)));
    write_file(path, file);
  }

  KeptContent read_kept_file(const std::string &path, const std::string &key)
  {
    std::ifstream file(path, std::ios::binary);
    if (!file.is_open())
      return {};
    std::string line(first_line.size(), '\0'), stored;
    file.read(line.data(), line.size());
    std::getline(file, stored);
    std::ostringstream read;
    read << file.rdbuf();
    std::string rest = read.str();
    if (line != first_line || stored != checksum(rest))
      return {{}, "is damaged"};
    const std::string head = head_of(key);
    if (rest.compare(0, head.size(), head) != 0)
      return {{}, "belongs to other parameters or another version"};
    return {rest.erase(0, head.size()), ""};
  }
} // namespace ringmotor
