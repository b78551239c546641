// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace ringmotor::tests
{
  /** A new empty folder, removed by the destructor. */
  class Scratch
  {
  public:
    Scratch() : folder(std::filesystem::temp_directory_path() / "ringmotor_XXXXXX")
    {
      if (mkdtemp(folder.data()) == nullptr)
        throw std::runtime_error("cannot make a folder for the test");
    }
    ~Scratch() { std::filesystem::remove_all(folder); }

    std::string path(const std::string &name) const { return folder + "/" + name; }
    std::size_t n_entries() const
    {
      const std::filesystem::directory_iterator entries(folder);
      return std::distance(begin(entries), end(entries));
    }

  private:
    std::string folder;
  };

  /** All bytes of a file. */
  inline std::string content_of(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  /** The message of the exception of this type that @p action throws, "nothing thrown" otherwise.
   */
  template <typename Exception, typename Action>
  std::string message_of(const Action &action)
  {
    try
    {
      action();
    }
    catch (const Exception &exception)
    {
      return exception.what();
    }
    return "nothing thrown";
  }
} // namespace ringmotor::tests
