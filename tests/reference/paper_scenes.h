#pragma once

#include "reference/scene.h"

/// The paper's specimens as scenes (Park & Tsuruno, table 1), typed in.
namespace nacre::reference {

inline ModelScene paper_morpho() {
    ModelScene scene;
    scene.name = "morpho";
    scene.mechanism = Palette{{{0, {460, 70, 1.0}}, {40, {395, 60, 0.7}}}, 0.26};
    return scene;
}

inline ModelScene paper_morpho_width() {
    ModelScene scene = paper_morpho();
    scene.name = "morpho_width";
    scene.y = {"width_nm", 20, 200};
    return scene;
}

inline ModelScene paper_beetle() {
    ModelScene scene;
    scene.name = "beetle";
    scene.mechanism = Palette{{{10, {530, 110, 0.73}}, {60, {460, 110, 1.0}}}, 0.91};
    return scene;
}

}  // namespace nacre::reference
