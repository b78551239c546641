// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/mesh/body_origin.h>
#include <ringmotor/mesh/contact_line.h>
#include <ringmotor/mesh/face_profile.h>
#include <ringmotor/mesh/rotor_sector.h>
#include <ringmotor/mesh/sector_mesh.h>

#include <memory>
#include <vector>

namespace ringmotor
{
  struct Parameters;

  /** Where a body has material at any angle, in the plane of r and z (m). */
  struct Meridian
  {
    std::vector<std::vector<dealii::Point<2>>> cells; ///< convex polygons, counterclockwise
    std::vector<dealii::Point<2>> outline;            ///< points on outer faces, close together
  };

  /**
   * A body of a motor, whatever describes it: dimensions or a section, which are revolved, or a
   * file of one sector. It tells what the body has, and meshes its sector. Levels 0, 1, 2, ... are
   * finer meshes: a section is graded anew towards re-entrant corners, the cells of a file are all
   * halved.
   */
  class BodyShape
  {
  public:
    explicit BodyShape(BodyOrigin origin) : origin(std::move(origin)) {}
    virtual ~BodyShape() = default;

    virtual bool has_part(const dealii::types::material_id part) const = 0;
    /** Whether it has faces with an id of mesh/ids.h. */
    virtual bool has_face(const dealii::types::boundary_id name) const = 0;
    virtual ContactLine contact_line() const                           = 0;
    /** Whether the faces in contact are connected. */
    virtual bool has_whole_contact() const = 0;
    /** The shape of the face in contact where it is a gap, see most_depth_of_profile. */
    virtual FaceProfile profile() const = 0;
    /** From the innermost to the outermost point of a part; empty without it. */
    virtual RadialRange radii_of(const dealii::types::material_id part) const = 0;
    virtual Meridian meridian() const                                         = 0;
    /** Which part of its sector is meshed. */
    virtual SectorForm form() const = 0;

    /** The mesh of its sector. */
    virtual SectorMesh sector(const unsigned int level, MPI_Comm communicator) const = 0;

    const BodyOrigin origin;
  };

  class StatorShape : public BodyShape
  {
  public:
    using BodyShape::BodyShape;

    /** Whether there are slots between its teeth. */
    virtual bool has_slots() const = 0;
    /** The radii of its lower faces on the felt, see radii_on_felt(). */
    virtual std::vector<RadialRange> on_felt() const = 0;

    /** A single tooth, clamped at its foot, on the cells of sector(). */
    virtual SectorMesh tooth(const unsigned int level, MPI_Comm communicator) const = 0;

    /**
     * A single tooth for its contact with a lip that covers these radii. The faces of its top below
     * the lip carry ids::tooth_top, those of its foot ids::tooth_foot. A section is divided anew,
     * see make_contact_tooth(); those of the cells of a file that are at its edges are cut
     * into as many, see cut_at_contact().
     */
    virtual SectorMesh contact_tooth(const RadialRange &lip, const InterfaceGrading &grading,
                                     MPI_Comm communicator) const = 0;
  };

  class RotorShape : public BodyShape
  {
  public:
    using BodyShape::BodyShape;

    /** N/m^3, of bars at the faces ids::radial_bars. */
    virtual double bar_stiffness() const = 0;

    /** Its sector for its contact with the teeth; of a section see make_rotor_sector(). Cells of a
     * file are cut at re-entrant edges until they are as small as the grading says against its
     * level 0, and at the face in contact, see cut_at_contact(). */
    virtual SectorMesh contact_sector(const RotorGrading &grading, const InterfaceGrading &lip,
                                      MPI_Comm communicator) const = 0;
  };

  /** @throws UserError for an unsuitable file, see read_section() and read_sector(), for slots that
   * leave no teeth, parts without material, and bars and felts without a face or the other way
   * round */
  std::unique_ptr<const StatorShape> stator_shape(const Parameters &parameters);
  std::unique_ptr<const RotorShape> rotor_shape(const Parameters &parameters);

  /** m, by which a rotor is raised to lie on the tooth tops of a stator. */
  double rise_to_contact(const BodyShape &rotor, const BodyShape &stator);

  /** Reads the files of bodies that the parameters name. @throws UserError as above, and for an
   * amplitude of the wave that is not small compared to the stator's height */
  void check_bodies(const Parameters &parameters);
} // namespace ringmotor
