#include "nacre/accuracy/model_curve.h"
#include "nacre/accuracy/choose_sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>

#include "nacre/accuracy/trial.h"
#include "nacre/colour/illuminant.h"
#include "nacre/lut/sampler.h"
#include "nacre/scene/readers/axis_reader.h"

namespace nacre {
namespace {

Job job_of(Mechanism mechanism) {
    LightSettings settings;
    settings.power = *illuminant_by_name("D65");
    Job job;
    job.material = {"m", std::move(mechanism), {}};
    job.light = std::make_shared<const Light>(make_light(settings));
    return job;
}

Job decided(Job job) {
    job.sampling = default_sampling(job);
    return job;
}

Layer layer_of(const Index& index, double thickness_nm) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    return layer;
}

Stack mirror(int pairs) {
    Layer group;
    group.repeat = pairs;
    group.layers = {layer_of(2.3, 60.0), layer_of(1.38, 100.0)};
    return {1.0, {group}, 1.52};
}

double display_scale_of(const Job& job) {
    Sampler sampler(job);
    double brightest = 0.0;
    for (int i = 0; i <= 100; ++i) brightest = std::max(brightest, sampler.at(i / 100.0).y);
    return 1.0 / brightest;
}

// The largest difference at random points, ends included.
double largest_difference(const Job& job, const ModelCurve& curve, double scale) {
    Sampler sampler(job);
    std::mt19937 generator(5);
    double largest = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double x = i == 0 ? 0.0 : i == 1 ? 1.0 : std::uniform_real_distribution<double>(0.0, 1.0)(generator);
        largest = std::max(largest, difference_at(curve.at(x), sampler.at(x), scale));
    }
    return largest;
}

void expect_keeps_its_tolerance(const Job& job) {
    const double scale = display_scale_of(job);
    for (const double tolerance : {1e-2, 1e-4}) {
        const ModelCurve curve(job, tolerance, scale);
        EXPECT_LE(largest_difference(job, curve, scale), tolerance) << tolerance;
        EXPECT_GT(curve.work().spectra, 0u);
    }
}

TEST(ModelCurve, OfAFilmIsTheModel) {
    expect_keeps_its_tolerance(decided(job_of(Film{1.0, 1.5, 400.0, 1.0})));
    expect_keeps_its_tolerance(decided(job_of(Film{1.0, 1.5, 3000.0, 1.8})));
    expect_keeps_its_tolerance(decided(job_of(Film{1.0, 2.4, 150.0, RefractiveIndex(0.2, 3.4)})));
}

TEST(ModelCurve, OfAStackIsTheModel) {
    expect_keeps_its_tolerance(decided(job_of(mirror(8))));
}

TEST(ModelCurve, OfAPrismIsTheModelAcrossItsCriticalAngles) {
    Stack prism = mirror(3);
    prism.incident = 1.7;
    prism.substrate = 1.0;
    expect_keeps_its_tolerance(decided(job_of(prism)));
    // All three faces lose light that grazes them, one after the other.
    expect_keeps_its_tolerance(decided(job_of(Stack{1.8, {layer_of(1.6, 300.0), layer_of(1.4, 500.0)}, 1.0})));
}

TEST(ModelCurve, OnEveryAxisIsTheModel) {
    for (const AxisKind& kind : axis_kinds()) {
        if (kind.quantity != Quantity::incidence) continue;
        Job job = job_of(Film{1.0, 1.5, 400.0, 1.33});
        job.x.kind = &kind;
        expect_keeps_its_tolerance(decided(std::move(job)));
    }
}

TEST(ModelCurve, OverAParameterIsTheModel) {
    Job job = job_of(Film{1.0, 1.5, 400.0, 1.33});
    job.fixed = Incidence::from_degrees(30.0);
    job.x = parameter_axis(job.material.mechanism, "thickness_nm", 0.0, 1500.0);
    expect_keeps_its_tolerance(decided(std::move(job)));
}

TEST(ModelCurve, AsksForTheModelLessOftenThanSettlingWould) {
    const Job job = decided(job_of(Film{1.0, 1.5, 400.0, 1.0}));
    const ModelCurve curve(job, 1e-3, display_scale_of(job));
    EXPECT_LT(curve.work().spectra, 2048u) << "a scan of the smallest LUT alone looks at so many points";
}

TEST(ModelCurve, ATighterToleranceAsksMoreOften) {
    const Job job = decided(job_of(Film{1.0, 1.5, 3000.0, 1.8}));
    const double scale = display_scale_of(job);
    EXPECT_LT(ModelCurve(job, 1e-1, scale).work().spectra, ModelCurve(job, 1e-5, scale).work().spectra);
}

TEST(ModelCurve, EndsWhenItIsTold) {
    const Job job = decided(job_of(Film{1.0, 1.5, 3000.0, 1.8}));
    int steps = 0;
    EXPECT_THROW(ModelCurve(job, 1e-6, 1.0,
                            [&] {
                                if (++steps == 3) throw std::runtime_error("stop");
                            }),
                 std::runtime_error);
    EXPECT_EQ(steps, 3);
}

}  // namespace
}  // namespace nacre
