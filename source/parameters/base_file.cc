// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/assign.h>
#include <ringmotor/parameters/base_file.h>
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace ringmotor
{
  namespace
  {
    /** @throws UserError unless a value can be the path of a file */
    void check_base(const PrmFile::Assignment &base)
    {
      const Notation<std::string> notation = path();
      if (notation.read(base.value))
        return;
      throw UserError(base.place + ": Base file" +
                      explain_refusal(base.value, {notation.allowed, "", "", true}));
    }

    /** Spelled as the file that names it is: a relative path stays one. */
    std::string path_of_base(const PrmFile &file)
    {
      return (std::filesystem::path(file.name).parent_path() / file.base->value)
          .lexically_normal()
          .string();
    }

    bool is_same_file(const std::string &one, const std::string &other)
    {
      std::error_code no_throw;
      return std::filesystem::equivalent(one, other, no_throw);
    }

    PrmFile read_base(const PrmFile &file)
    {
      const std::string base = path_of_base(file);
      try
      {
        return parse_prm(text_of_prm(base), base);
      }
      catch (const UserError &error)
      {
        std::error_code no_throw;
        if (std::filesystem::is_regular_file(base, no_throw))
          throw;
        throw UserError(file.base->place + ": Base file = " + in_quotes(file.base->value) +
                        " cannot be used: " + error.what() +
                        "; a relative path is searched in the folder of the file that names it");
      }
    }
  } // namespace

  std::string text_of_prm(const std::string &path)
  {
    std::error_code no_throw;
    if (!std::filesystem::exists(path, no_throw))
      throw UserError(path + ": no such parameter file; examples are in the folder prm");
    if (std::filesystem::is_directory(path, no_throw))
      throw UserError(path + ": is a folder; give a parameter file (.prm)");
    std::ifstream stream(path);
    const std::string text((std::istreambuf_iterator<char>(stream)),
                           std::istreambuf_iterator<char>());
    if (!stream.is_open() || stream.bad())
      throw UserError(path + ": cannot be read; check its permissions");
    return text;
  }

  std::vector<PrmFile> with_bases(const PrmFile &file)
  {
    std::vector<PrmFile> files{file};
    while (files.back().base)
    {
      check_base(*files.back().base);
      const std::string next = path_of_base(files.back());
      for (const PrmFile &earlier : files)
        if (is_same_file(earlier.name, next))
          throw UserError(files.back().base->place + ": Base file = " +
                          in_quotes(files.back().base->value) + " leads back to " + earlier.name +
                          "; a file cannot be based on itself, name another one");
      files.push_back(read_base(files.back()));
    }
    std::reverse(files.begin(), files.end());
    return files;
  }
} // namespace ringmotor
