// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/structure/modes.h>
#include <ringmotor/structure/response_modes.h>
#include <ringmotor/structure/revolved_modes.h>

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace ringmotor
{
  /** The nodal diameter, 0 .. N / 2, of a harmonic of the wave as the teeth sample it. */
  unsigned int nodal_diameter_of_harmonic(const Motor &motor, const unsigned int harmonic);

  /** The harmonics 1 to @p n_harmonics by their nodal diameter. */
  std::map<unsigned int, std::vector<unsigned int>>
  harmonics_by_diameter(const Motor &motor, const unsigned int n_harmonics);

  /** The motion of the contact points by a wave on the surface of a half sector, real field, then
   * imaginary one; their rotor nodes may belong to neighbouring sectors. @param turn the wave's
   * phase from one sector to the next (rad) */
  std::vector<std::array<std::complex<double>, 3>>
  at_contact_points(const std::vector<double> &half, const std::vector<MirroredNode> &origin,
                    const MortarCoupling &mortar, const double turn);

  /** Nodal diameters by the lowest harmonic of the wave that they have, both ends included. */
  struct HarmonicRange
  {
    unsigned int first = 1, last = std::numeric_limits<unsigned int>::max();

    bool contains(const unsigned int harmonic) const
    {
      return first <= harmonic && harmonic <= last;
    }
  };

  /** Modes of nodal diameters on one mesh, by these and by the harmonics of the wave that excite
   * them. */
  template <typename ModeType>
  using ModesByDiameter =
      std::map<std::pair<const unsigned int, std::vector<unsigned int>>, std::vector<ModeType>>;

  /** Finds the vibrations of LipModes, the rotor's interior included. */
  class RotorModeSolver
  {
  public:
    /** See LipModes. @param kept modes that this rank has found on the same mesh, for pictures:
     * those found here are added unless any frequency excites them; it must outlive this object */
    RotorModeSolver(const Parameters &parameters, const unsigned int level, const double frequency,
                    const unsigned int n_harmonics, const HarmonicRange &range = {},
                    ModesByDiameter<Mode> *kept = nullptr);

    /** The nodal diameters that have modes, with the harmonics of the wave that excite them; none
     * are named where the rotor moves as a whole, as any frequency does. */
    const std::map<unsigned int, std::vector<unsigned int>> &diameters() const { return excited; }

    /** The modes of one of these, sorted by frequency, normalised on the meshed half sector. */
    std::vector<Mode> modes(const unsigned int k);
    /** Whether this rank has kept them. */
    bool has_kept(const unsigned int k) const { return kept && kept->count(*excited.find(k)) > 0; }

    const RotorBody body;

  private:
    bool any_frequency = false;    ///< excites the rotor, which moves as a whole
    const double frequency, up_to; ///< rad/s; modes below the latter if the rotor moves as a whole
    std::map<unsigned int, std::vector<unsigned int>> excited;
    std::optional<RevolvedModes> revolved;  ///< where the rotor is a body of revolution
    std::optional<ResponseModes> responses; ///< where it is not: of excited frequencies
    std::optional<ModeSolver> all;          ///< or of all
    ModesByDiameter<Mode> *const kept;

    std::vector<Mode> compute(const unsigned int k);
  };

  /**
   * The vibrations of the rotor with two nodal diameters and more, on a separate mesh. With fewer
   * nodal diameters the rotor also moves as a whole: in a uniform ring its response to these is
   * static, and each other nodal diameter is excited at the frequencies of a few harmonics only.
   * Ritz vectors give its response there (RevolvedModes,
   * ResponseModes). A rotor that moves as a whole, see
   * MotorModel, is excited at any frequency: it has the modes of all nodal diameters from two on up
   * to two thirds of the frequency of the highest harmonic, and in addition the inertia of its rise
   * and its near-rigid modes; its elastic deformation with fewer than two nodal diameters remains
   * static.
   */
  class LipModes
  {
  public:
    struct LipMode
    {
      double angular_frequency;
      std::vector<double> motion; ///< of the half sector's lip, real field, then imaginary one

      template <class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &angular_frequency &motion;
      }
    };
    /** What has been computed on one mesh. */
    struct Known
    {
      ModesByDiameter<LipMode> on_lip; ///< the same on all ranks
      ModesByDiameter<Mode> whole;     ///< those that this rank keeps
    };

    /** @param level of the mesh; @param frequency rad/s, of the wave; @param n_harmonics of the
     * wave that may matter; @param communicator of the ranks that share the nodal diameters;
     * @param range of the nodal diameters that have modes here; @param known with the same
     * parameters on this mesh: taken over if they have the same harmonics, and added to;
     * @param keeps_whole adds the rotor's interior */
    LipModes(const Parameters &parameters, const unsigned int level, const double frequency,
             const unsigned int n_harmonics, MPI_Comm communicator = MPI_COMM_SELF,
             const HarmonicRange &range = {}, Known *known = nullptr,
             const bool keeps_whole = false);

    /** The rotor's discretisation for its modes at a level. */
    static ContactDiscretisation discretisation(const unsigned int level);

    /** At the contact points on @p tooth_top. @param lip_turn see ContactDiscretisation */
    RingModes at(const ContactSurface &tooth_top, const double lip_turn) const;

    const std::vector<LipMode> &of_diameter(const unsigned int k) const { return modes[k]; }

    /** A mode of @p body on its half sector's lip; friction does not excite it if the rotor does
     * not give way along the lip. */
    static LipMode on_lip(const RotorBody &body, const Mode &mode, const bool gives_way_along);
    /** The mode of the whole sector at contact points. @param turn see at_contact_points() */
    static RingMode at_points(const LipMode &mode, const SectorSurface &lip,
                              const MortarCoupling &mortar, const double turn);

  private:
    const unsigned int n_teeth;
    SectorSurface lip;
    std::vector<std::vector<LipMode>> modes; ///< by nodal diameter
  };

  /** How accurately vibrations are known. */
  struct VibrationSetting
  {
    /** Of LipModes::discretisation() and tooth_modes_discretisation(): for the low harmonics of the
     * wave. Those above #n_low shake the rotor on the coarsest mesh. */
    unsigned int mesh;
    unsigned int n_low;
    unsigned int n_harmonics; ///< in which bodies vibrate; in all others they respond as at rest
  };

  /** The vibrations of a rotor at levels of increasing accuracy: in the mesh and the number of low
   * harmonics, whose resonances have to be known one by one, and in the number of all harmonics.
   * Computed lazily. */
  class RotorVibration
  {
  public:
    static constexpr unsigned int finest_level = 3;
    /** To estimate what effects change. */
    static constexpr unsigned int rough_level = 0;
    /** For tight targets, to begin with. */
    static constexpr unsigned int usual_level = 2;

    /** @param frequency rad/s, of the wave @param communicator of the ranks that share the work:
     * at() and prepare() are collective where they compute something */
    RotorVibration(const Parameters &parameters, const double frequency,
                   MPI_Comm communicator = MPI_COMM_SELF);

    /** The setting of a level. */
    VibrationSetting setting(const unsigned int level) const;
    /** The same on the next coarser mesh. */
    VibrationSetting on_coarser_mesh(const unsigned int level) const;
    /**
     * That on the coarser mesh with other harmonics, which shows what those left out change.
     * Contact excites resonances far up, one by one: what a few harmonics change says little of the
     * next ones. Therefore half as many again as the forty-five that are never left out. Where the
     * rotor moves as a whole and has the modes of all nodal diameters, these would be too many:
     * those of the next lower level.
     */
    VibrationSetting of_other_harmonics(const unsigned int level) const;

    /** The modes at the contact points on @p tooth_top. @param lip_turn see ContactDiscretisation
     */
    RingModes at(const VibrationSetting &setting, const ContactSurface &tooth_top,
                 const double lip_turn) const;
    /** Those that find the modes of at() again, with the rotor's interior, or have kept them; each
     * nodal diameter has modes in one of them at most. */
    std::vector<std::unique_ptr<RotorModeSolver>> solvers(const VibrationSetting &setting) const;
    /** That of a level, and those that tell its error. */
    std::vector<VibrationSetting> settings(const unsigned int level, const ModeSets sets) const;
    /** Computes what condense_motor() reads: before ranks condense different motors. Of the level's
     * own modes the interior is kept for pictures, if these are drawn. */
    void prepare(const unsigned int modes_level,
                 const ModeSets sets = ModeSets::with_compared) const;
    /** Those of all nodal diameters for the first harmonics, on the mesh of a level. */
    const LipModes &of_harmonics(const unsigned int n_harmonics, const unsigned int level) const;
    /** See rotor_loss_factor(). */
    double loss_factor() const;

  private:
    /** Modes on one mesh. */
    struct Part
    {
      unsigned int mesh, n_harmonics;
      HarmonicRange range;
    };
    /** On the mesh of a setting, and on the coarsest one. */
    std::vector<Part> parts(const VibrationSetting &setting) const;
    /** Their modes, computed if they are not known. */
    const LipModes &modes_of(const Part &part, const bool keeps_whole = false) const;

    Parameters parameters;
    double frequency;
    bool moves_as_a_whole;
    MPI_Comm communicator;
    /** What has been computed. */
    struct Results
    {
      /** By mesh, range of nodal diameters, number of harmonics. */
      std::map<std::tuple<unsigned int, unsigned int, unsigned int, unsigned int>,
               std::unique_ptr<const LipModes>>
          modes;
      std::map<unsigned int, LipModes::Known> by_mesh;
      std::optional<double> loss_factor;
    };
    std::shared_ptr<Results> results = std::make_shared<Results>(); ///< shared by copies
  };
} // namespace ringmotor
