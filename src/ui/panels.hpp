#pragma once

#include "ui/dropped_files.hpp"
#include "ui/overlay_stack.hpp"
#include "ui/panel_context.hpp"

namespace drape {

/// The sections of the column. Each draws its own heading and, when that is open, its content.
void materialPanel(PanelContext& context);
void airPanel(PanelContext& context);
void simulationPanel(PanelContext& context);
void contactPanel(PanelContext& context);
void scenePanel(PanelContext& context);
void viewPanel(PanelContext& context);
void ghostPanel(PanelContext& context);
void performancePanel(PanelContext& context);
void advancedPanel(PanelContext& context);

/// The scene's title and the buttons that start, stop and rewind; always in sight above the sections.
void headPanel(PanelContext& context);

/// The line at the bottom of the window, over its whole width: the cloth and its pace, and what is worth telling. It
/// grows upwards over the picture where a message needs more room. A click on it tells of the solver.
void statusLine(PanelContext& context, const UiRect& place);

/// What went wrong, in full. Gives back false once the user has closed it.
[[nodiscard]] bool errorNotice(PanelContext& context, OverlayStack& stack);

/// What is being read or built, and how far that is.
void loadingNotice(PanelContext& context, OverlayStack& stack);

/// What to do first.
void dragHint(OverlayStack& stack);

/// What wants an answer, a line each until it has one: how a mesh file was read, pins that hold all or nothing, and
/// cloth that is overstretched. Each line has a button for what would help and one that accepts.
void readingNotice(PanelContext& context, OverlayStack& stack);

/// The list of keys and mouse gestures over the picture. Gives back false once the user has closed it.
[[nodiscard]] bool helpOverlay(PanelContext& context, const UiRect& view);

/// Asks which of several files is the cloth: the index of a mesh, or of the scene beyond the meshes. The answer is an
/// OpenPartsRequest. Gives back false once it is answered.
[[nodiscard]] bool dropQuestion(PanelContext& context, const UiRect& view, const DroppedFiles& files,
                                std::size_t& cloth);

/// Asks before changes are lost. Gives back false once it is answered.
[[nodiscard]] bool quitQuestion(PanelContext& context, const UiRect& view);

/// Tells the direction and the strength of the wind as seen from above; dragging turns it.
void windDial(PanelContext& context);

/// The recent cost of a step [ms] as a small filled curve.
void historyPlot(const PanelContext& context, const History& history);

/// What a solver that chooses for itself chose for the steps of the last seconds, and what came of it.
void choicePlots(const PanelContext& context);

}  // namespace drape
