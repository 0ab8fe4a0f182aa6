#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "hydro/database/Coefficients.h"

namespace cutwater {

class FreeResponse;
class RadiationModel;
class SeaState;
struct SeaCache;  // of SeaTables
class WaveExcitation;

/// What all ships of one database share. Make it once, give it to every ship:
///     const auto frigate = cutwater::readHydrodynamics("frigate.h5");
///     seaway.addShip(frigate, {.start = {.x = 0}});
///     seaway.addShip(frigate, {.start = {.x = 300}});
/// It owns its coefficients and lives as long as somebody holds it, and so do the wave loads of the
/// last seas that it was asked for: a second world with the same waves is ready at once. Immutable
/// but for what is made when first asked for; any thread may call.
class Hydrodynamics {
 public:
  /// @param form of the forward-speed terms; absent: the database's own, or Tuck's where the
  ///              database lacks the x-derivatives that its own form needs.
  /// @throws HydroError BadArgument: a null pointer; DatabaseIncomplete: unfinished coefficients.
  explicit Hydrodynamics(std::shared_ptr<const Coefficients> coefficients,
                         std::optional<ForwardSpeedForm> form = {});
  explicit Hydrodynamics(Coefficients coefficients, std::optional<ForwardSpeedForm> form = {})
      : Hydrodynamics(std::make_shared<const Coefficients>(std::move(coefficients)), form) {}
  ~Hydrodynamics();

  const Coefficients& coefficients() const noexcept { return *coefficients_; }
  const ShipParticulars& ship() const noexcept { return coefficients_->ship; }
  ForwardSpeedForm form() const noexcept { return form_; }
  double length() const noexcept { return length_; }  ///< of the hull, or of its panels [m]
  double keel() const noexcept { return keel_; }      ///< lowest point, hull axes [m]
  double top() const noexcept { return top_; }  ///< highest, 0 of a hull known below water only

  /// Whether the database holds a closed hull, on which pressure can be integrated.
  bool closedHull() const noexcept { return closedHull_; }

  /// Hash of ship, A, B and form: another one for other hydrodynamics, the same in every process.
  std::uint64_t key() const noexcept { return key_; }

  /// Internal: retardation functions and their fit, made once.
  /// @throws HydroError as RadiationModel.
  std::shared_ptr<const RadiationModel> radiation() const;
  /// Internal: forces of single waves, made once.  @throws HydroError as WaveExcitation.
  const WaveExcitation& excitation() const { return excitation(form_); }
  const WaveExcitation& excitation(ForwardSpeedForm form) const;
  /// Internal: how a free ship answers a wave, made once.  @throws HydroError as radiation().
  const FreeResponse& freeResponse() const;
  /// Speeds at which the ship's own motions grow, in this form and with its own supplementary
  /// terms. Found once, in some hundredths of a second.  @throws HydroError as radiation().
  const SpeedStability& stability() const;
  /// Speed [m/s] up to which that was looked at: the database's last one, or Fn 0.6.
  double fastest() const;
  /// Internal: wave loads on this ship in waves of these frequencies and headings. The last
  /// kSeasKept of them are kept, and those in use.
  std::shared_ptr<SeaCache> cacheOf(const SeaState& sea) const;
  static constexpr std::size_t kSeasKept = 8;

 private:
  std::shared_ptr<const Coefficients> coefficients_;
  ForwardSpeedForm form_;
  double length_, keel_, top_;
  bool closedHull_;
  std::uint64_t key_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const RadiationModel> radiation_;
  mutable std::array<std::unique_ptr<const WaveExcitation>, 2> excitation_;  // by form
  mutable std::unique_ptr<const FreeResponse> freeResponse_;
  mutable std::optional<SpeedStability> stability_;
  mutable std::vector<std::shared_ptr<SeaCache>> seas_;  // the last one asked for comes last
};

/// Reads a database (CoefficientsFile.h) to be shared by ships.
/// @param warning  receives one line that says what a plain BEMIO file lacks, or near which
///        frequencies the ship's motions are not right because the water resonates; or "".
/// @throws HydroError as readCoefficients and Hydrodynamics.
std::shared_ptr<const Hydrodynamics> readHydrodynamics(const std::string& path,
                                                       std::string* warning = nullptr);

}  // namespace cutwater
