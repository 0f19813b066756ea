#pragma once

#include "report/hardcases/hard_case.hpp"

/// The functions of the cases, grouped by file. The table of cases.cpp lists them.
namespace drape::report::hardcases {

// starts.cpp
void randomStart(CaseTrial& trial);
void flattened(CaseTrial& trial);
void onePoint(CaseTrial& trial);
void crushed(CaseTrial& trial);

// materials.cpp
void unevenSprings(CaseTrial& trial);
void unevenMasses(CaseTrial& trial);
void fineAndStiff(CaseTrial& trial);
void heavyGravity(CaseTrial& trial);
void scales(CaseTrial& trial);

// free_motion.cpp
void freeFall(CaseTrial& trial);
void spinning(CaseTrial& trial);

// rest.cpp
void oneCorner(CaseTrial& trial);
void largeAtRest(CaseTrial& trial);

// time.cpp
void randomFrames(CaseTrial& trial);
void changedWhileRunning(CaseTrial& trial);
void longSteps(CaseTrial& trial);

// outside.cpp
void pinsTeleport(CaseTrial& trial);
void storm(CaseTrial& trial);
void thrown(CaseTrial& trial);

// input.cpp
void degenerateTriangles(CaseTrial& trial);
void looseMesh(CaseTrial& trial);
void nothingThere(CaseTrial& trial);

// fabric_starts.cpp
void fabricFolded(CaseTrial& trial);
void fabricTurnedOver(CaseTrial& trial);
void fabricCompressed(CaseTrial& trial);
void fabricDamped(CaseTrial& trial);
void fabricViolentStart(CaseTrial& trial);
void fabricPinsTeleport(CaseTrial& trial);

// fabric_materials.cpp
void fabricLongSteps(CaseTrial& trial);
void fabricSlivers(CaseTrial& trial);
void fabricUnevenModuli(CaseTrial& trial);
void fabricThinCells(CaseTrial& trial);
void fabricOverstretched(CaseTrial& trial);

// contact_driven.cpp
void contactTwisted(CaseTrial& trial);
void contactRing(CaseTrial& trial);
void contactVice(CaseTrial& trial);
void contactCrumpled(CaseTrial& trial);
void contactDragged(CaseTrial& trial);

// contact_dropped.cpp
void contactSharp(CaseTrial& trial);
void contactFiveSheets(CaseTrial& trial);
void contactSofa(CaseTrial& trial);
void contactTwoLayers(CaseTrial& trial);
void contactLongSteps(CaseTrial& trial);

}  // namespace drape::report::hardcases
