#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nacre/base/least_squares.h"
#include "nacre/colour/light.h"
#include "nacre/lut/axis.h"
#include "nacre/material/effects.h"
#include "nacre/material/mechanism.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/readers/index_reader.h"
#include "nacre/scene/scene_context.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {

/// One image of XYZ: everything that bake() needs, with no name left to look up and no default left to choose.
struct Job {
    Material material;
    std::shared_ptr<const Light> light;
    Axis x = default_axis();
    std::optional<Axis> y;
    int width = 256;
    int height = 1;                       ///< 1 without y
    Geometry fixed;                       ///< where neither axis is the angle
    Integral integral = Integral::exact;  ///< of palettes, unless the light samples spectra
    SpectralSampling sampling;            ///< of everything else
    EffectSet without;                    ///< effects of the material that are not simulated
};

/// Which OpenColorIO config, space and gamut. The config itself is opened by the front end.
struct ColourSettings {
    std::string config;  ///< file as the scene names it; empty: $OCIO, else ours
    Where config_where;
    std::string space = "lin_rec709";
    bool is_space_given = false;  ///< else the front end looks for linear Rec.709 by its other names too
    Where space_where;
    Gamut gamut = Gamut::keep;
    std::string interchange;
};

/// "256 x 1".
std::string size_text(const Job& job);

/// How the job's spectra become XYZ: "exact", "fast", "48 nodes", "48 nodes x 256", "471 wavelengths".
std::string integration_text(const Job& job);

/// What a scene says of a LUT's accuracy. What it leaves open is decided by settle(), where the colour space is known.
struct AccuracyWish {
    double max_de00 = default_max_de00;  ///< largest CIEDE2000 error of what a shader fetches
    /// Whether there is a bound at all: not so where the scene gives `size` or `wavelengths` and no bound.
    bool has_bound = true;
    /// Whether the user gave it: then a LUT that errs by more is refused. The default is a goal; who misses it is
    /// warned.
    bool is_binding = false;
    std::optional<int> width;
    std::optional<int> height;
    std::optional<PixelFormat> format;
    std::optional<Integral> integral;
    std::optional<NodeCounts> nodes;  ///< wavelengths of spectra that are sampled, per band of angles
    std::optional<int> realisations;  ///< of irregular ones
    QuadratureWish points;            ///< of effects that are integrals
    /// Whether effects that make no difference that counts are left out; else all are simulated but these.
    bool may_drop_effects = true;
    EffectSet without;

    static constexpr double default_max_de00 = 0.1;
};

/// One LUT: <name>.exr and what goes with it.
struct PlannedLut {
    std::string name;
    Job job;  ///< its size and integral are placeholders until settle() has decided them; so is the format
    AccuracyWish wish;
    PixelFormat format = PixelFormat::half_float;
    std::vector<LutOutput> outputs{LutOutput::exr, LutOutput::json};
    Where where;
};

/// One picture: <name>.png.
struct PlannedSwatch {
    std::string name;
    SwatchKind kind = SwatchKind::strip;
    std::string title;
    std::vector<Job> jobs;  ///< plane, strip, sphere: one; palette: one per pick shown
    std::string display;    ///< empty: the config's default
    std::string view;
    Gamut gamut = Gamut::compress;  ///< compress or clip: how colours that an sRGB display lacks are shown
    Where where;
};

struct Plan {
    std::shared_ptr<const Light> light;
    ColourSettings colour;
    std::vector<std::string> names;        ///< of all LUTs and swatches that the scene has, asked for or not
    std::vector<std::string> warnings;     ///< of what is allowed and hardly meant, with file, line and column
    std::vector<Material> materials;       ///< those that were read
    std::vector<MaterialSearch> searches;  ///< of these, what picks of films, stacks, gratings and crystals led to
    std::vector<PlannedLut> luts;
    std::vector<PlannedSwatch> swatches;
};

/// How the core asks for the files that a scene names.
struct SceneFiles {
    CurveReader read_curve;
    MaterialReader find_material;
    SpectraReader read_spectra;
    /// A picked colour's XYZ, by the scene's OpenColorIO config; empty: colours cannot be read here.
    std::function<Xyz(const Rgb& colour, const std::string& space, const Where& where, const ColourSettings& settings)>
        read_colour{};
    /// Of a library; empty: see LobeFinder.
    LeastSquaresSolver least_squares{};
    /// Looks for mechanisms that show what picks ask for, best first, at least one (see fit/find_mechanism.h); empty:
    /// such picks cannot be read here.
    std::function<std::vector<FoundMechanism>(const MechanismSearch& search, const Light& light)> find_mechanisms{};
};

/// What of a scene is wanted.
struct PlanRequest {
    /// Names of LUTs and swatches; empty: all. Names that the scene does not have are no error: another scene may.
    std::vector<std::string> only;
    bool all_materials = false;  ///< those too that no LUT and no swatch asks for
    bool strict = false;         ///< whether a picked colour that no band, film, ... has is an error

    bool wants(const std::string& name) const;
};

/// Decides everything that a scene leaves open. After it only the disk can fail.
///
/// Every mistake of the user's is found here: unknown keys and names, wrong types, numbers out of range, picks that
/// contradict each other. Throws Error with file, line and column.
/// Materials that nothing asks for are not read at all, nor are the files that they name.
/// @param scene  the top table of a scene, includes resolved
Plan plan_scene(const Table& scene, const SceneFiles& files, const PlanRequest& request = {});

/// A scene that holds one LUT and nothing else, every default written out: what a file header carries so that the LUT
/// can be derived again. plan_scene() of it gives the same job, and this text again.
std::string scene_toml(const PlannedLut& lut, const ColourSettings& colour);

/// Bounds that a user may give: below the least, single precision and the fast integral drown in their own rounding.
inline constexpr Allowed allowed_max_de00{1e-5, 100.0};

/// The longest side of a LUT, in texels.
inline constexpr int largest_lut_size = 4096;

}  // namespace nacre
