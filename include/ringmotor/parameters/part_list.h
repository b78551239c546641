// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <initializer_list>
#include <memory>
#include <vector>

namespace ringmotor
{
  /** The objects of a list whose members are one class each, in a file of their own that offers no
   * more than a function that makes it: effects, friction laws, error causes. */
  template <typename Part>
  using PartList = std::vector<std::unique_ptr<const Part>>;

  /** Those that these functions make, in their order. */
  template <typename Part>
  PartList<Part> made_by(const std::initializer_list<std::unique_ptr<const Part> (*)()> makers)
  {
    PartList<Part> list;
    for (const auto make : makers)
      list.push_back(make());
    return list;
  }

  /** What each of them declares to the parameters. */
  template <typename Entry, typename Part>
  std::vector<Entry> entries_of(const PartList<Part> &list)
  {
    std::vector<Entry> entries;
    for (const auto &part : list)
      entries.push_back(part->entry);
    return entries;
  }
} // namespace ringmotor
