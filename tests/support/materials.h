// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/cyclic_sector.h>

namespace ringmotor::tests
{
  /** The default material of the benchmarks. */
  constexpr Material steel{200.e9, 0.3, 8000., 0.};

  /** A body of one material throughout. */
  inline MaterialTable all_of(const Material &material)
  {
    return {{ids::base, material}, {ids::tooth, material}, {ids::piezoceramic, material}};
  }

  /** Those of the reference stator. */
  inline MaterialTable stator_materials(const Materials &materials = {})
  {
    return {{ids::base, materials.stator_metal},
            {ids::tooth, materials.stator_metal},
            {ids::piezoceramic, materials.piezoceramic}};
  }
} // namespace ringmotor::tests
