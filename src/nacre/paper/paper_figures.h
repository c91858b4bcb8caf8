#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "nacre/colour/light.h"
#include "nacre/optics/palette.h"
#include "nacre/paper/paper.h"

namespace nacre {

// The figures of Park & Tsuruno 2014 as numbers: pure functions from the paper's equations and parameters to tables.

/// Numbers as a table, and what they are: one CSV file.
struct Series {
    std::string name;     ///< the file without ".csv"
    std::string comment;  ///< one line
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;  ///< each as long as `columns`; NaN: there is no such number

    /// Largest and mean absolute value in a column, of the rows whose first column lies in [from, to] and that have
    /// one; 0 if none has.
    /// @pre the column exists
    double largest(const std::string& column, double from, double to) const;
    double mean(const std::string& column, double from, double to) const;
    /// The number in a column of the row whose first column is `first`.
    /// @pre both exist
    double value(double first, const std::string& column) const;

private:
    std::size_t index_of(const std::string& column) const;
    std::vector<double> magnitudes(const std::string& column, double from, double to) const;
};

/// In columns of peaks: a spectrum without one.
inline constexpr double no_peak = std::numeric_limits<double>::quiet_NaN();

/// A palette's picks: angle, peak, width, height. The squares of Figures 8, 9 and 11.
Series paper_picks(const Specimen& specimen);
/// Figure 5: the lobe of a pick, every 0.5 nm, with some black on either side.
Series paper_figure5(const Pick& pick);
/// Figure 7: path_factor() / n and its straight line against the angle, for three indices.
Series paper_figure7();
/// Figure 8: Bragg's peak against the angle; beside it (3.2.5) through the two picks, as nacre bakes it, (3.2.5) fitted
/// to all angles, and (3.2.4), the same with p = 1, through the picks; and the peak of the exact stack behind that law.
Series paper_figure8(const Specimen& specimen);
/// Figure 9: peak, width and height against the angle, before and after clamping.
Series paper_figure9(const Specimen& specimen);
/// Figure 11: colours of the plane of peak wavelength and angle, XYZ (D65) and linear Rec.709, coarser than the
/// picture.
Series paper_figure11(const Specimen& specimen, const std::shared_ptr<const Light>& light);
/// Figure 12: colours of the plane of width and height at each pick, likewise.
Series paper_figure12(const Specimen& specimen, const std::shared_ptr<const Light>& light);
/// Figure 14: reflectance at the specimen's angles, one column per angle, every 0.5 nm.
Series paper_figure14(const Specimen& specimen);
/// The colour of each curve of Figure 14: angle, lobe, XYZ (D65) and linear Rec.709.
Series paper_figure14_colours(const Specimen& specimen, const Light& light);
/// What floor and flatness add to the paper's band: reflectance of four bands at 380-780 nm, every 0.5 nm.
Series paper_bands();
/// The numbers of these four bands, one band per row.
Series paper_band_lobes();
/// The perfect reflector by (A.1) and (A.2): equal energy, 380-780 nm, not adapted, in linear Rec.709.
Series paper_white();

/// The default light of a scene: D65, 2 degrees.
std::shared_ptr<const Light> default_light();

}  // namespace nacre
