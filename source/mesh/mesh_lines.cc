// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/mesh_lines.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    unsigned int n_significant_digits(const std::string_view number)
    {
      unsigned int n_digits = 0;
      for (const char c : number.substr(0, number.find_first_of("eE")))
        if (c >= '0' && c <= '9' && (c != '0' || n_digits > 0))
          ++n_digits;
      return n_digits;
    }
  } // namespace

  MeshLines::MeshLines(MeshFile &file) : file(file), input(file.name)
  {
    if (!input)
      file.refuse("it cannot be opened", "check the name and the permissions");
  }

  bool MeshLines::go_on()
  {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // of some editors
    while (std::getline(input, line))
    {
      if (++number_of_line == 1 && line.rfind(byte_order_mark, 0) == 0)
        line.erase(0, byte_order_mark.size());
      split();
      if (!words.empty())
        return true;
    }
    words.clear();
    return false;
  }

  void MeshLines::skip_to(const std::string &title)
  {
    while (words.empty() || words[0] != title)
      next();
  }

  std::string MeshLines::word(const std::size_t place) const
  {
    expect(words.size() > place);
    return std::string(words[place]);
  }

  long MeshLines::count(const std::size_t place) const
  {
    const long value = number<long>(place);
    expect(value >= 0);
    return value;
  }

  long MeshLines::id(const std::size_t place) const
  {
    const long value = number<long>(place);
    expect(value != std::numeric_limits<long>::min());
    return std::abs(value);
  }

  Point<3> MeshLines::point(const std::size_t place)
  {
    Point<3> x;
    for (unsigned int d = 0; d < 3; ++d)
    {
      x[d] = number<double>(place + d);
      expect(std::isfinite(x[d]));
      file.n_digits = std::max(file.n_digits, n_significant_digits(words[place + d]));
    }
    return x;
  }

  void MeshLines::expect(const bool condition) const
  {
    if (!condition)
      file.refuse("it is damaged, or not a mesh in Gmsh's ASCII format of version 2.2 or 4.1 "
                  "(line " +
                      std::to_string(number_of_line) + ")",
                  "save it again as such, with " + file.format);
  }

  void MeshLines::split()
  {
    constexpr const char *blanks = " \t\r\v\f";
    words.clear();
    for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string::npos;)
    {
      const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
      words.push_back(std::string_view(line).substr(begin, end - begin));
      begin = line.find_first_not_of(blanks, end);
    }
  }
} // namespace ringmotor
