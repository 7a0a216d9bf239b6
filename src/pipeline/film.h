#pragma once

#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/guides/material_age.h"
#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"
#include "fluidymation/synthesis/exemplar.h"
#include "pipeline/film_window.h"
#include "pipeline/inputs.h"
#include "pipeline/stopping.h"

namespace fluidymation {

/// The film of a run: an exemplar that holds all of it, or some frames at a time (`FilmWindow`).
/// What is held does not depend on the place from where the film was advanced to it.
class Film {
 public:
  /// @param begin  the first film frame to be held at first.
  /// All must outlive this.
  Film(const Options& options, const Inputs& inputs, const FilmWindow& window, int begin,
       const Stopping& stopping);

  /// Reads all pictures of the film, and keeps those to be held: what cannot be read is known
  /// before anything is written. @throws Interrupted, Error.
  void readPictures();

  /// Goes through all guides of the film, dumps them where that is wanted, and completes the
  /// exemplar by those to be held.
  /// @param guides  must outlive this; `keeps` unless the window is the whole film.
  /// @param withAges  whether they hold ages.
  /// @throws Interrupted, Error.
  void readGuides(GuideStream& guides, bool withAges, const Observer& observer);

  /// Advances to where film frame `begin` is the first one that is held, unless the film is as far
  /// already. @throws Interrupted, Error.
  void advanceTo(int begin);

  [[nodiscard]] const Exemplar& exemplar() const { return exemplar_; }

 private:
  /// The guides of the film frame after the one asked for last, or of the first one.
  [[nodiscard]] GuideFrame nextGuides();
  /// Fills in what the exemplar holds of guides that were not given yet, from film frame `from` on.
  void fillGuides(int from);
  [[nodiscard]] bool holds(int frame) const;

  const Options& options_;
  const Inputs& inputs_;
  const Stopping& stopping_;
  bool isWhole_;
  Exemplar exemplar_;
  GuideStream* guides_ = nullptr;
  bool withAges_ = false;
  FilmAges ages_;
  int guidesGiven_ = 0;  ///< frames whose guides were asked for since they began
};

/// Makes sure that the film has material in whatever the window holds of it.
/// @throws Error naming --src-mask-path where it has none at all, UsageError naming --src-window
///   where the window is too small to reach from one frame with material to the next.
void requireMaterial(const Options& options, const FilmWindow& window, const GuideStream& guides);

}  // namespace fluidymation
