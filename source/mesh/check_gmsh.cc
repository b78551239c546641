// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_gmsh.h>

#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ringmotor
{
  namespace
  {
    using Integers = std::vector<long>;

    /** All numbers of a line; nothing if it has anything else. */
    template <typename Number>
    std::optional<std::vector<Number>> numbers_of(const std::string &line)
    {
      std::istringstream words(line);
      std::vector<Number> numbers;
      for (Number number; words >> number;)
        numbers.push_back(number);
      if (!words.eof())
        return {};
      return numbers;
    }

    /** How many nodes an element of one of Gmsh's kinds has, those that deal.II reads. */
    std::optional<std::size_t> n_nodes_of(const long kind)
    {
      static const std::map<long, std::size_t> n_nodes{{15, 1}, {1, 2}, {2, 3}, {3, 4},
                                                       {4, 4},  {5, 8}, {6, 6}, {7, 5}};
      const auto found = n_nodes.find(kind);
      if (found == n_nodes.end())
        return {};
      return found->second;
    }

    class GmshFile
    {
    public:
      explicit GmshFile(std::istream &input) : input(input) {}

      bool is_whole()
      {
        next();
        if (line == "$NOD")
          return nodes(false) && line == "$ENDNOD" && goes_on_with("$ELM") && elements(5) &&
                 line == "$ENDELM";
        if (line != "$MeshFormat" || !next())
          return false;
        const auto format     = numbers_of<double>(line); // version, ASCII, bytes of a number
        const bool has_blocks = format == std::vector<double>{4.1, 0, 8};
        if (!has_blocks && format != std::vector<double>{2.2, 0, 8})
          return false;
        return goes_on_with("$Nodes") && nodes(has_blocks) && line == "$EndNodes" &&
               goes_on_with("$Elements") && (has_blocks ? blocks_of_elements() : elements(3)) &&
               line == "$EndElements";
      }

    private:
      /** The next line that is not empty. */
      bool next()
      {
        while (std::getline(input, line))
        {
          boost::algorithm::trim(line);
          if (!line.empty())
            return true;
        }
        line.clear();
        return false;
      }

      /** Reads on to the line with a title. */
      bool goes_on_with(const std::string &title)
      {
        while (line != title)
          if (!next())
            return false;
        return true;
      }

      /** Reads the next line: at least @p n_least integers that are not negative. */
      bool integers(const std::size_t n_least, Integers &found)
      {
        next();
        const auto numbers = numbers_of<long>(line);
        found              = numbers.value_or(Integers());
        return found.size() >= n_least &&
               std::none_of(found.begin(), found.end(), [](const long n) { return n < 0; });
      }

      bool is_point(const std::size_t n_before)
      {
        const auto numbers = numbers_of<double>(line);
        return numbers && numbers->size() == n_before + 3 &&
               std::all_of(numbers->begin(), numbers->end(),
                           [](const double x) { return std::isfinite(x); });
      }

      bool nodes(const bool in_blocks)
      {
        Integers head;
        if (!integers(1, head))
          return false;
        if (in_blocks)
          return blocks_of_nodes(head);
        for (long node = 0; node < head[0]; ++node)
        {
          if (!next() || !is_point(1))
            return false;
          char *end = nullptr;
          tags.insert(std::strtol(line.c_str(), &end, 10)); // does not throw
          if (*end != ' ' && *end != '\t')
            return false;
        }
        return next() && tags.size() == static_cast<std::size_t>(head[0]);
      }

      /** Blocks of tags followed by as many points. */
      bool blocks_of_nodes(const Integers &head)
      {
        Integers block, tag;
        for (long b = 0; b < head[0]; ++b)
        {
          if (!integers(4, block))
            return false;
          for (long node = 0; node < block[3]; ++node)
          {
            if (!integers(1, tag) || tag.size() != 1)
              return false;
            tags.insert(tag[0]);
          }
          for (long node = 0; node < block[3]; ++node)
            if (!next() || !is_point(0))
              return false;
        }
        return next() && head.size() == 4 && tags.size() == static_cast<std::size_t>(head[1]);
      }

      /** Whether from a place on a line has the nodes of an element of a kind. */
      bool joins_nodes(const Integers &numbers, const std::size_t begin, const long kind) const
      {
        const auto n_nodes = n_nodes_of(kind);
        return !n_nodes || // deal.II refuses those
               (numbers.size() == begin + *n_nodes &&
                std::all_of(numbers.begin() + begin, numbers.end(),
                            [this](const long tag) { return tags.count(tag) > 0; }));
      }

      /** Elements with their tags: a fixed number of them up to version 1, as many as are announced
       * at the third place since. @p n_first numbers precede tags that are announced, or nodes. */
      bool elements(const std::size_t n_first)
      {
        Integers head, element;
        if (!integers(1, head))
          return false;
        for (long e = 0; e < head[0]; ++e)
        {
          if (!integers(n_first, element))
            return false;
          const std::size_t n_tags = n_first == 3 ? element[2] : 0;
          if (n_tags > element.size() || !joins_nodes(element, n_first + n_tags, element[1]))
            return false;
        }
        return next();
      }

      bool blocks_of_elements()
      {
        Integers head, block, element;
        if (!integers(4, head))
          return false;
        long n_found = 0;
        for (long b = 0; b < head[0]; ++b)
        {
          if (!integers(4, block) || block[0] > 3)
            return false;
          for (long e = 0; e < block[3]; ++e)
            if (!integers(2, element) || !joins_nodes(element, 1, block[2]))
              return false;
          n_found += block[3];
        }
        return next() && n_found == head[1];
      }

      std::istream &input;
      std::string line;
      std::set<long> tags; ///< of nodes
    };
  } // namespace

  bool is_whole_gmsh(std::istream &input)
  {
    return GmshFile(input).is_whole();
  }
} // namespace ringmotor
