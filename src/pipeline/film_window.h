#pragma once

#include "fluidymation/options.h"

namespace fluidymation {

/// Frames of a film that are held at a time (P§5): so many consecutive ones, further on in the film
/// for every frame of the target.
class FilmWindow {
 public:
  /// @param options      for --src-window and --temporal-coherence.
  /// @param filmFrames   of the whole film, >= 1.
  /// @param targetFrames  of the whole target, >= 1.
  FilmWindow(const Options& options, int filmFrames, int targetFrames);

  /// In [1, filmFrames].
  [[nodiscard]] int heldFrames() const { return heldFrames_; }
  [[nodiscard]] bool isWhole() const { return heldFrames_ == filmFrames_; }

  /// The first film frame that is held for a frame of the target: the film's first one for the
  /// target's first, so that the film's last is held for the target's last, and between them in
  /// even steps. Where frames are painted in both directions of time, the frames of one window of
  /// these (`kWindowFrames`) hold the same ones.
  [[nodiscard]] int beginFor(int targetFrame) const;

 private:
  int heldFrames_;
  int filmFrames_;
  int targetFramesPerStep_;
  int steps_;  ///< places of the window, as far as the target's frames tell them apart
};

}  // namespace fluidymation
