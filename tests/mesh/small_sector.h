// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "output/scratch.h"

#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/read_sector.h>
#include <ringmotor/parameters/errors.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace ringmotor::tests
{
  inline SectorMesh read(const std::string &path, const unsigned int n_sectors)
  {
    return read_sector(path, n_sectors, MPI_COMM_WORLD);
  }

  /** Expects that reading @p path is refused in one line with these words. */
  inline void expect_refusal(const std::string &path, const std::vector<std::string> &words,
                             const unsigned int n_sectors = 6)
  {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const std::string message = message_of<UserError>([&]() { read(path, n_sectors); });
    EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(message.find("Stator/Mesh file = \""), 0u) << message;
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos) << '"' << word << "\" not in: " << message;
    for (const std::string unwanted : {"\n", "dealii", "Exc"})
      EXPECT_EQ(message.find(unwanted), std::string::npos) << unwanted << " in: " << message;
  }

  /** The text of a mesh, nodes and elements. */
  class SectorText
  {
  public:
    struct Element
    {
      int type, id;
      std::vector<int> nodes; ///< from 0
    };
    std::vector<std::array<double, 3>> nodes; ///< (r, theta, z) in m and degrees
    std::vector<Element> elements;

    void add(const int type, const int id, const std::vector<int> &element_nodes)
    {
      elements.push_back({type, id, element_nodes});
    }

    void mark_all(const int id, const int other)
    {
      for (Element &element : elements)
        if (element.id == id)
          element.id = other;
    }

    /** Writes it in Gmsh's format 2.2, lengths multiplied by @p scale. */
    std::string write(const Scratch &scratch, const double scale = 1.,
                      const int n_digits = 17) const
    {
      const std::string path = scratch.path("sector.msh");
      std::ofstream out(path);
      out.precision(n_digits);
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << nodes.size() << '\n';
      for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const auto &[r, theta, z] = nodes[i];
        const double angle        = theta * M_PI / 180.;
        out << i + 1 << ' ' << scale * r * std::cos(angle) << ' ' << scale * r * std::sin(angle)
            << ' ' << scale * z << '\n';
      }
      out << "$EndNodes\n$Elements\n" << elements.size() << '\n';
      for (unsigned int i = 0; i < elements.size(); ++i)
      {
        out << i + 1 << ' ' << elements[i].type << " 2 " << elements[i].id << " 1";
        for (const int node : elements[i].nodes)
          out << ' ' << node + 1;
        out << '\n';
      }
      out << "$EndElements\n";
      return path;
    }
  };

  /** A ring of six sectors without slots, 20 to 30 mm in radius; three cells in theta, two in z
   * (base and tooth). */
  class SmallSector : public SectorText
  {
  public:
    explicit SmallSector(const SectorForm form = SectorForm::whole)
    {
      const bool half = form == SectorForm::half;
      for (const double z : {0., 5e-3, 8e-3})
        for (const double share : {0., 1. / 3., 2. / 3., 1.})
          for (const double r : {20e-3, 30e-3})
            nodes.push_back({{r, half ? 30. * share : -30. + 60. * share, z}});
      for (const int k : {0, 1})
        for (const int j : {0, 1, 2})
          add(5, k == 0 ? ids::base : ids::tooth,
              {at(0, j, k), at(1, j, k), at(1, j + 1, k), at(0, j + 1, k), at(0, j, k + 1),
               at(1, j, k + 1), at(1, j + 1, k + 1), at(0, j + 1, k + 1)});
      for (const int k : {0, 1})
        for (const int j : {0, 3})
          add(3, j == 0 ? (half ? ids::mirror : ids::cut_low) : (half ? ids::cut : ids::cut_high),
              {at(0, j, k), at(1, j, k), at(1, j, k + 1), at(0, j, k + 1)});
      for (const int j : {0, 1, 2})
        add(3, ids::tooth_top, {at(0, j, 2), at(1, j, 2), at(1, j + 1, 2), at(0, j + 1, 2)});
    }

    static int at(const int i, const int j, const int k) { return i + 2 * j + 8 * k; }
  };
} // namespace ringmotor::tests
