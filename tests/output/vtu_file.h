// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scratch.h"

#include <algorithm>
#include <array>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstdint>
#include <cstring>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>
#include <zlib.h>

namespace ringmotor::tests
{
  inline std::string from_base64(std::string text)
  {
    using namespace boost::archive::iterators;
    using Decoder = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;

    const std::size_t n_padding = std::count(text.begin(), text.end(), '=');
    std::replace(text.begin(), text.end(), '=', 'A');
    std::string bytes(Decoder(text.cbegin()), Decoder(text.cend()));
    bytes.resize(bytes.size() - n_padding);
    return bytes;
  }

  /** A VTU file: one piece, every array one block compressed with zlib. */
  class VtuFile
  {
  public:
    explicit VtuFile(const std::string &path) : text(content_of(path)) {}

    unsigned int count(const std::string &what) const
    {
      std::smatch match;
      const std::string head = text.substr(0, 1000);
      return std::regex_search(head, match, std::regex("NumberOf" + what + "=\"(\\d+)\""))
                 ? std::stoul(match[1])
                 : 0;
    }

    bool has_old_node_order() const
    {
      return text.find("type=\"UnstructuredGrid\" version=\"2.2\"") == std::string::npos;
    }

    /** An array by its name, or the positions for "". */
    template <typename Number>
    std::vector<Number> array(const std::string &name) const
    {
      const std::string key = name.empty() ? "<Points>" : "Name=\"" + name + "\"";
      const std::size_t tag = text.find(key);
      if (tag == std::string::npos)
        throw std::runtime_error("no array " + name);
      const std::size_t first = text.find('\n', text.find("binary", tag)) + 1;
      const std::string code  = text.substr(first, text.find('\n', first) - first);

      // number of blocks, their size, the last one's size, compressed size: 16 bytes, 24 letters
      std::array<std::uint32_t, 4> head;
      std::memcpy(head.data(), from_base64(code.substr(0, 24)).data(), sizeof(head));
      const std::string packed = from_base64(code.substr(24));
      std::vector<Number> values(head[1] / sizeof(Number));
      uLongf n_bytes = head[1];
      if (head[0] != 1 || packed.size() != head[3] ||
          uncompress(reinterpret_cast<Bytef *>(values.data()), &n_bytes,
                     reinterpret_cast<const Bytef *>(packed.data()), packed.size()) != Z_OK)
        throw std::runtime_error("damaged array " + name);
      return values;
    }

    /** The values of a vector field, or the positions for "". */
    std::vector<std::array<double, 3>> vectors(const std::string &name) const
    {
      const std::vector<float> flat = array<float>(name);
      std::vector<std::array<double, 3>> result;
      for (std::size_t i = 0; i + 2 < flat.size(); i += 3)
        result.push_back({{flat[i], flat[i + 1], flat[i + 2]}});
      return result;
    }

  private:
    const std::string text;
  };
} // namespace ringmotor::tests
