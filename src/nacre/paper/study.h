#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nacre/colour/difference.h"
#include "nacre/colour/light.h"
#include "nacre/material/mechanism.h"
#include "nacre/paper/paper_figures.h"
#include "nacre/paper/study_user.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {

// A user study without users: how many moves of sliders an automatic user needs until a picture is a given one, with
// the picks of Park & Tsuruno 2014 and with the physical parameters of Sun 2006 (ACM TOG 25(1)).

/// A number of an interface, and its range. Every slider starts in the middle.
struct Slider {
    std::string name;
    double from = 0.0;
    double to = 1.0;
};

/// One way to describe a material: sliders, and what they make.
struct StudyWay {
    std::string name;   ///< as in column names: "picks"
    std::string title;  ///< for people
    std::vector<Slider> sliders;
    Mechanism (*material)(const std::vector<double>& values) = nullptr;

    /// @param positions  one per slider, each in [0, 1]
    Mechanism at(const std::vector<double>& positions) const;
    std::vector<double> start() const { return std::vector<double>(sliders.size(), 0.5); }
};

/// Two bands, at 0 and 40 degrees, with peak, width and height each: what the paper's plane and palettes set.
StudyWay picks_way();
/// Six films with air between: both thicknesses, the films' index, and how much all thicknesses vary.
StudyWay layers_way();
/// Both, in this order.
std::vector<StudyWay> study_ways();

/// The colours of a material at 0, 5, ..., 80 degrees under D65, as they are before a display limits them. Beyond 80
/// degrees lies the rim of a sphere, 3 % of its disc.
using StudyPicture = std::vector<Lab>;

/// Draws pictures. Different threads may share one.
class StudyPainter {
public:
    StudyPainter();
    StudyPicture paint(const Mechanism& mechanism) const;

private:
    std::shared_ptr<const Light> light_;
    SpectralSampling sampling_;
};

/// The mean of CIEDE2000 over the angles.
double picture_difference(const StudyPicture& one, const StudyPicture& other);
/// A picture that differs by less counts as the target. 1 is about a just noticeable difference of two colours side by
/// side.
inline constexpr double study_goal = 2.0;

/// A picture to be reached.
struct StudyTarget {
    bool is_of_layers = false;      ///< made by random physical parameters; else by random picks
    std::vector<double> positions;  ///< of the sliders of layers_way() or picks_way() that made it
    StudyPicture picture;
};

inline constexpr int study_targets = 50;

/// The target of a number: an even one is made by picks, an odd one by layers. It depends on nothing else.
StudyTarget study_target(int number, const StudyPainter& painter);

/// What the automatic user does for one target.
struct StudyRun {
    bool is_of_layers = false;          ///< as of StudyTarget
    std::vector<UserOutcome> outcomes;  ///< one per way
};
StudyRun study_run(int number, const StudyPainter& painter);
/// Of all targets.
std::vector<StudyRun> study_runs();

/// One row per half of the targets and way: number of targets, how many were reached, quartiles of the moves to reach
/// one (NaN where fewer were reached), and the median of the difference that was left.
Series study_summary(const std::vector<StudyRun>& runs);

/// After each number of moves, for each half of the targets and way: the share reached, and the median difference.
Series study_curves(const std::vector<StudyRun>& runs);

}  // namespace nacre
