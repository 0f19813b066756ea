#pragma once

#include "ui/dropped_files.hpp"
#include "ui/overlay_stack.hpp"
#include "ui/panel_context.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace drape::ui {

/// The sections of the column (sections.cpp has their table): a heading each and, when open, the settings of its group.
void drawSections(PanelContext& context);

/// Rows of the section Material, below its settings.
void materialRows(PanelContext& context);

/// Rows of the section Contact, and whether contact is the main subject of the scene.
void contactRows(PanelContext& context);
[[nodiscard]] bool contactMatters(const PanelContext& context);

/// Whether a body of the scene can be dressed: it is drawn and switched on, and has an inside.
[[nodiscard]] bool hasBodyToDress(const session::Snapshot& snapshot);

/// The word on the button that dresses the body: "Dress", or "Dress again" once that was done or the cloth moved.
[[nodiscard]] const char* dressWord(const session::Snapshot& snapshot);

/// Choices of the unit of a mesh file, side by side in the width of the next item, each stored as "NAME=cm". None is
/// marked where the file has another unit. @param unit as in the setting `unit` @return the one that the user chooses,
/// else `unit`
[[nodiscard]] std::string unitChoice(PanelContext& context, const std::string& name, const std::string& unit);
/// The same for the axis that points up.
[[nodiscard]] std::string upChoice(PanelContext& context, const std::string& name, const std::string& up);

/// What that button does.
inline constexpr const char* dressHelp =
    "Puts the cloth on the body and removes all intersections, without pins. The clock waits meanwhile.";

/// The number of pairs of triangles of the cloth that are known to intersect.
[[nodiscard]] int intersectingPairsOf(const session::Snapshot& snapshot);

/// Rows of the section Scene: above its settings a field for a file and the scene's help, below them facts of the mesh.
void sceneRows(PanelContext& context);
void meshRows(PanelContext& context);

/// The rows of the section Scene for the motion and the proportions of figures; nothing without a figure.
void figureRows(PanelContext& context);

/// The rows of the section Scene that choose the clips of bodies; nothing where no file of a body has several.
void clipRows(PanelContext& context);

/// The rows of the section View that choose the theme and the language.
void themeRow(PanelContext& context);
void languageRow(PanelContext& context);

/// The list of files that were opened before; nothing while there are none.
void recentFilesRow(PanelContext& context);

/// The title of the section Export, which is also the name by which it is shown, and its rows.
inline constexpr std::string_view exportSection = "Export";
void exportRows(PanelContext& context);

/// The row that starts a selection of vertices.
void selectRow(PanelContext& context);

/// The selected vertices in the picture, and a box with what can be done with them. Nothing while there are none.
void selectionBox(PanelContext& context, const UiRect& view);

/// The rows of that box for the keyframes of pins. Nothing without pins among the selected vertices.
void pinKeyRows(PanelContext& context, const std::vector<int>& selected, float width);
/// The row that starts the mode Place.
void placeRow(PanelContext& context);

/// The rows that start the mode Sew, and list the seams and the elastic bands of the cloth.
void sewingRows(PanelContext& context);

/// The borders in the picture, and a box with what can be done with them. Nothing while the mode Sew is off.
void sewingBox(PanelContext& context, const UiRect& view);

/// The slider of the length of an elastic band. @return the new length when the user changed it
[[nodiscard]] std::optional<double> bandSlider(PanelContext& context, const std::string& key, double length);

/// Draws borders, pairs and seams behind all panels.
void drawSewing(PanelContext& context, const SewingView& sewing, const UiRect& view);

/// The gizmo in the picture, and a box with the placement of the chosen thing. Nothing while the mode Place is off.
void placingBox(PanelContext& context, const UiRect& view);

/// Draws the gizmo and the box around the thing behind all panels.
void drawGizmo(PanelContext& context, const PlacingView& placing, const UiRect& view);

/// The rows of the section View for the camera.
void cameraRows(PanelContext& context);

/// Rows of the section Performance.
void performanceRows(PanelContext& context);

/// The button that compares the sources of error, and the result.
void errorSourcesRows(PanelContext& context);

/// The last check of the error in words, if there is one.
void accuracyText(const PanelContext& context);

/// The title of the scene and the buttons play, step and reset; always visible above the sections.
void headPanel(PanelContext& context);

/// The line at the bottom of the window: the cloth, its speed and the most urgent message. It grows upwards when a
/// message needs more room. A click opens details of the solver. @return the height by which it grew,
/// in window coordinates
double statusLine(PanelContext& context, const UiRect& place);

/// The full text of an error. False once the user closed it.
[[nodiscard]] bool errorNotice(PanelContext& context, OverlayStack& stack);

/// The file or scene in progress, and how far it is.
void loadingNotice(PanelContext& context, OverlayStack& stack);

/// The dressing that is under way, how far it is, and a button that cancels it.
void dressingNotice(PanelContext& context, OverlayStack& stack);

/// The export that is under way, how far it is, and a button that cancels it.
void exportNotice(PanelContext& context, OverlayStack& stack);

/// The legend of the colour map at a corner of the picture, or why its quantity does not exist. Nothing while it is
/// off.
/// @param above height of what lies below it [window units]
void colourLegend(PanelContext& context, const UiRect& view, float above);

/// The slider of the timeline at the bottom of the picture. Nothing without recorded states.
/// @return the height that it takes [window units]
float timelineBar(PanelContext& context, const UiRect& view);

/// The values at picked vertices, at a corner of the picture. Nothing without any.
void pickedPanel(PanelContext& context, const UiRect& view);

/// The hint for a new user.
void dragHint(const PanelContext& context, OverlayStack& stack);

/// The open questions, one line each until the user answers: how a mesh file was read, pins on all vertices or none,
/// overstretched cloth, and a body that passes through the cloth. Each line has a button for the remedy and one that
/// accepts the present state.
void readingNotice(PanelContext& context, OverlayStack& stack);

/// The list of keys and mouse gestures over the picture. False once the user closed it.
[[nodiscard]] bool helpOverlay(PanelContext& context, const UiRect& view);

/// Tells what dropped files contain, and asks which one is the cloth, how they are read, and whether the others are
/// only opened with it, or wear it. The answer is an OpenPartsRequest. False once it is answered.
[[nodiscard]] bool dropQuestion(PanelContext& context, const UiRect& view, const DroppedFiles& files,
                                DropChoices& choices);

/// Asks before a scene file is replaced. False once it is answered.
[[nodiscard]] bool replaceQuestion(PanelContext& context, const UiRect& view, const std::string& file);

/// What is lost by quitting: the export that is under way, and changes of the scene that are not saved.
[[nodiscard]] text::Sentence whatQuittingLoses(const std::optional<ExportProgress>& exporting, bool hasChanges);

/// Asks before changes are lost. False once it is answered.
[[nodiscard]] bool quitQuestion(PanelContext& context, const UiRect& view, bool hasChanges);

/// Shows the direction and speed of the wind from above; dragging changes it.
void windDial(PanelContext& context);

/// The recent durations of a step [ms] as a small filled curve.
void historyPlot(const PanelContext& context, const History& history);

/// The choices of a solver such as auto in the last seconds, and their results.
void choicePlots(const PanelContext& context);

}  // namespace drape::ui
