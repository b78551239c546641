// SPDX-License-Identifier: LGPL-2.1-or-later

// What meshes/README.md asks of the ids and of the place of a sector, each sentence broken once:
// with a stator of six teeth that has a ceramic ring and slots, or half of its sector. Sound meshes
// of other shapes are read.

#include "mesh/small_sector.h"

#include <functional>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  constexpr int n_layers = 5, n_without_slot = 3; ///< ceramic, base (2); tooth (2)

  /** A sector with one tooth from -20 to 20 degrees. */
  class ToothedSector : public SectorText
  {
  public:
    explicit ToothedSector(const SectorForm form = SectorForm::whole, const int first_layer = 0)
        : ToothedSector(
              form == SectorForm::half,
              form == SectorForm::half ? std::vector<double>{0., 10., 20., 30.}
                                       : std::vector<double>{-30., -20., -7., 7., 20., 30.},
              [=](const int layer, const double theta)
              { return layer >= first_layer && (layer < n_without_slot || std::abs(theta) < 20.); })
    {
    }

    /** The cells at lines of these angles for which @p is_there(layer, theta in the middle). */
    ToothedSector(const bool half, const std::vector<double> &angles,
                  const std::function<bool(int, double)> &is_there)
        : half(half), angles(angles)
    {
      const std::array<int, n_layers> id_of_layer{
          {ids::piezoceramic, ids::base, ids::base, ids::tooth, ids::tooth}};
      for (const double z : {-1e-3, 0., 2.5e-3, 5e-3, 6.5e-3, 8e-3})
        for (const double angle : angles)
          for (const double r : {20e-3, 24e-3, 30e-3})
            nodes.push_back({{r, angle, z}});
      const int last = static_cast<int>(angles.size()) - 1;
      for (int k = 0; k < n_layers; ++k)
        for (int j = 0; j < last; ++j)
          if (is_there(k, 0.5 * (angles[j] + angles[j + 1])))
            for (const int i : {0, 1})
            {
              add_cell(id_of_layer[k], i, j, k);
              if (j == 0)
                add_side(half ? ids::mirror : ids::cut_low, i, 0, k);
              if (j + 1 == last)
                add_side(half ? ids::cut : ids::cut_high, i, last, k);
              if (k + 1 == n_layers)
                add_level(ids::tooth_top, i, j, n_layers);
            }
    }

    int at(const int i, const int j, const int k) const
    {
      return i + 3 * (j + static_cast<int>(angles.size()) * k);
    }

    void add_cell(const int id, const int i, const int j, const int k)
    {
      add(5, id,
          {at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
           at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)});
    }
    /** A face at constant theta, line j. */
    void add_side(const int id, const int i, const int j, const int k)
    {
      add(3, id, {at(i, j, k), at(i + 1, j, k), at(i + 1, j, k + 1), at(i, j, k + 1)});
    }
    /** A face at constant z, line k. */
    void add_level(const int id, const int i, const int j, const int k)
    {
      add(3, id, {at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)});
    }

    void move(const std::function<void(double &r, double &theta, double &z)> &change)
    {
      for (auto &[r, theta, z] : nodes)
        change(r, theta, z);
    }
    /** Gives the cells whose lowest nodes are at a height an id. */
    void mark_layer(const double z, const int id)
    {
      for (Element &element : elements)
        if (element.type == 5 && std::abs(nodes[element.nodes[0]][2] - z) < 1e-9)
          element.id = id;
    }

    const bool half;
    const std::vector<double> angles;
  };

  using Change = std::function<void(ToothedSector &)>;

  void expect_read(const ToothedSector &sector, const std::string &what)
  {
    const Scratch scratch;
    EXPECT_NO_THROW(read(sector.write(scratch), 6)) << what;
  }

  void expect_both_refused(const Change &change, const std::vector<std::string> &words)
  {
    for (const SectorForm form : {SectorForm::half, SectorForm::whole})
    {
      const Scratch scratch;
      ToothedSector sector(form);
      change(sector);
      expect_refusal(sector.write(scratch), words);
    }
  }

  void expect_refused(const SectorForm form, const Change &change,
                      const std::vector<std::string> &words)
  {
    const Scratch scratch;
    ToothedSector sector(form);
    change(sector);
    expect_refusal(sector.write(scratch), words);
  }
} // namespace

TEST(MarkedSector, IsReadInAllShapesThatStatorsHave)
{
  for (const SectorForm form : {SectorForm::half, SectorForm::whole})
  {
    expect_read(ToothedSector(form), "plain");
    ToothedSector bare(form, 1);
    expect_read(bare, "no ceramic");
    bare.move([](double &, double &, double &z) { z -= 3e-3; });
    expect_read(bare, "no ceramic, another origin of z");
    ToothedSector tapered(form);
    tapered.move([](double &r, double &, double &z) { r += r > 27e-3 ? -0.3 * z : 0.1 * z; });
    expect_read(tapered, "sloped sides");
    ToothedSector narrowed(form);
    narrowed.move([](double &, double &theta, double &z)
                  { theta = z > 5.1e-3 && std::abs(theta) < 21. ? 0.8 * theta : theta; });
    expect_read(narrowed, "a tooth that gets narrower");
    ToothedSector ceramic(form);
    ceramic.move([](double &r, double &, double &z) { r = z < 0. && r > 27e-3 ? 29e-3 : r; });
    expect_read(ceramic, "a narrower ceramic ring");
    ToothedSector sloped(form);
    sloped.move([](double &r, double &theta, double &z)
                { z = z == 5e-3 && std::abs(theta) > 21. ? z - 0.1 * (r - 20e-3) : z; });
    expect_read(sloped, "a slot whose bottom slopes below the tooth");
    ToothedSector milled(form);
    milled.move([](double &r, double &, double &z)
                { z = std::abs(z - 5e-3) < 1e-9 ? z - 0.1 * (r - 20e-3) : z; });
    expect_read(milled, "a tooth on a slope");
  }
  ToothedSector leaning;
  leaning.move([](double &r, double &theta, double &z)
               { theta += 300. * (r - 25e-3) + 200. * (z - 8e-3); });
  expect_read(leaning, "a leaning tooth and skewed cuts");
}

TEST(MarkedSector, IsRefusedIfOtherFacesAreTops)
{
  const std::string below = "lies below the highest point of the body";
  expect_both_refused(
      [](ToothedSector &sector)
      {
        for (const int k : {3, 4})
          sector.add_side(ids::tooth_top, 1, sector.half ? 2 : 4, k); // the tooth's end
      },
      {"physical id 15", below});
  expect_both_refused([](ToothedSector &sector) { sector.add_level(ids::tooth_top, 0, 0, 0); },
                      {below, "z = -1 mm"});
  expect_both_refused([](ToothedSector &sector)
                      { sector.add_level(ids::tooth_top, 0, sector.half ? 2 : 4, 3); }, // the slot
                      {below, "z = 5 mm"});
  expect_both_refused([](ToothedSector &sector) { sector.nodes[sector.at(1, 1, 5)][2] += 2e-6; },
                      {below, "level"});
  expect_both_refused([](ToothedSector &sector) { sector.mark_all(ids::tooth_top, 0); },
                      {"no face has the physical id 15"});
}

TEST(MarkedSector, IsRefusedIfPartOfTheTopIsNotMarked)
{
  // Each of the faces alone, then all of one radius or one angle.
  for (const int left : {0, 1, 2, 3, 4, 5})
  {
    const auto unmark = [&](ToothedSector &sector)
    {
      int number = 0;
      for (auto &element : sector.elements)
        if (element.id == ids::tooth_top)
        {
          const bool is_chosen = left < 4 ? number == left : number % 2 == left - 4;
          element.id           = is_chosen ? 0 : ids::tooth_top;
          ++number;
        }
    };
    expect_both_refused(unmark, {"belongs to the tooth's top but is not marked", "surface 15"});
  }
}

TEST(MarkedSector, IsRefusedIfVolumesAreExchanged)
{
  const auto exchange = [](const int a, const int b)
  {
    return [=](ToothedSector &sector)
    {
      sector.mark_all(a, 99);
      sector.mark_all(b, a);
      sector.mark_all(99, b);
    };
  };
  expect_both_refused(exchange(ids::base, ids::tooth),
                      {"tooth's top (physical id 15)", "belongs to the physical volume 1"});
  expect_both_refused(exchange(ids::tooth, ids::piezoceramic), {"to the physical volume 3"});
  expect_both_refused(exchange(ids::base, ids::piezoceramic),
                      {"no tooth cell (physical id 2) stands on a base cell (1)"});
  expect_both_refused([](ToothedSector &sector) { sector.mark_all(ids::tooth, ids::base); },
                      {"to the physical volume 1"});
  expect_both_refused([](ToothedSector &sector) { sector.mark_all(ids::base, ids::tooth); },
                      {"no volume has the physical id 1 (base)"});
  expect_both_refused([](ToothedSector &sector) { sector.mark_all(ids::piezoceramic, ids::tooth); },
                      {"the tooth (physical id 2) lies beside or below the base (1)"});
  // Half of the base or of the tooth
  expect_both_refused([](ToothedSector &sector) { sector.mark_layer(2.5e-3, ids::tooth); },
                      {"the tooth (physical id 2) reaches a cut"});
  expect_both_refused(
      [](ToothedSector &sector) { sector.mark_layer(5e-3, ids::base); },
      {"the tooth (physical id 2) begins at z = 6.5 mm", "slot's bottom at z = 5 mm"});
  expect_both_refused([](ToothedSector &sector) { sector.mark_layer(0., ids::piezoceramic); },
                      {"the piezoceramic (physical id 3) reaches up to z = 2.5 mm", "z = 0"});
}

TEST(MarkedSector, IsRefusedInOtherPlacesAlongTheAxis)
{
  for (const double shift : {-8e-3, -1e-5, 1e-5, 1e-3})
    expect_both_refused([&](ToothedSector &sector)
                        { sector.move([&](double &, double &, double &z) { z += shift; }); },
                        {"the piezoceramic (physical id 3) reaches up to z = ", "z = 0"});
  expect_both_refused([](ToothedSector &sector)
                      { sector.move([](double &, double &, double &z) { z = -z; }); },
                      {"lies below the highest point of the body", "turn the mesh over"});
  expect_both_refused([](ToothedSector &sector)
                      { sector.move([](double &, double &, double &z) { z = 1e-3 - z; }); },
                      {"turn the mesh over"});
}

TEST(MarkedSector, IsRefusedIfTheToothIsNotAtTheCentre)
{
  for (const double angle : {-15., -0.1, 0.1, 5.})
    expect_refused(SectorForm::whole,
                   [&](ToothedSector &sector)
                   { sector.move([&](double &, double &theta, double &) { theta += angle; }); },
                   {"tooth's top", "theta = 0 must be the centre of the tooth"});
  // The slot is at the mirror plane.
  expect_refused(SectorForm::half,
                 [&](ToothedSector &sector)
                 {
                   sector.move([&](double &, double &theta, double &) { theta = 30. - theta; });
                   sector.mark_all(ids::mirror, 99);
                   sector.mark_all(ids::cut, ids::mirror);
                   sector.mark_all(99, ids::cut);
                 },
                 {"from 10 degrees to 30 degrees", "theta = 0 must be the centre of the tooth"});
  // The cuts divide a tooth, or the slot is at theta = 0.
  for (const double slot : {13., 0.})
  {
    const Scratch scratch;
    const ToothedSector sector(false, {-30., -20., -7., 7., 20., 30.},
                               [&](const int layer, const double theta)
                               { return layer < n_without_slot || std::abs(theta - slot) > 6.; });
    expect_refusal(sector.write(scratch), {"tooth's top", "begins or ends at 4 angles"});
  }
}

TEST(MarkedSector, IsRefusedIfItHasTwoIds)
{
  expect_both_refused([](ToothedSector &sector) { sector.add_cell(ids::tooth, 0, 0, 1); },
                      {"a volume has the physical ids 1 and 2"});
  expect_both_refused([](ToothedSector &sector)
                      { sector.add_level(sector.half ? ids::cut : ids::cut_low, 0, 1, 5); },
                      {"a surface has the physical ids 15 and 1"});
  // Not a face of any cell
  expect_both_refused([](ToothedSector &sector)
                      { sector.add_side(ids::tooth_top, 0, sector.half ? 3 : 5, 4); },
                      {"a surface with the physical id 15", "is not one of the marked volumes"});
}

TEST(MarkedSector, IsRefusedIfACutHasARadiusAndHeightTwice)
{
  // The cuts have a step in the middle of the base: below from -30 to 30 degrees, above from -20 to
  // 40.
  ToothedSector sector(false, {-30., -20., -7., 7., 20., 30., 40.},
                       [](const int layer, const double theta)
                       {
                         const bool is_below = layer < 2;
                         return layer < n_without_slot ? (is_below ? theta < 30. : theta > -20.)
                                                       : std::abs(theta) < 7.;
                       });
  for (const int i : {0, 1})
  {
    for (const int k : {0, 1})
      sector.add_side(ids::cut_high, i, 5, k);
    sector.add_side(ids::cut_low, i, 1, 2);
    sector.add_level(ids::cut_low, i, 0, 2);
    sector.add_level(ids::cut_high, i, 5, 2);
  }
  const Scratch scratch;
  expect_refusal(sector.write(scratch), {"two nodes at the same r and z"});
}
