#include "ui/theme.hpp"

#include "ui/embedded_fonts.hpp"

#include <array>
#include <cmath>
#include <cstring>

namespace drape::ui {
namespace {

ImVec4 rgb(unsigned hex, float alpha = 1.0F) {
  return {static_cast<float>((hex >> 16U) & 0xFFU) / 255.0F, static_cast<float>((hex >> 8U) & 0xFFU) / 255.0F,
          static_cast<float>(hex & 0xFFU) / 255.0F, alpha};
}

void applySizes(ImGuiStyle& style) {
  style.WindowPadding = {14.0F, 12.0F};
  style.FramePadding = {8.0F, 4.0F};
  style.ItemSpacing = {8.0F, 6.0F};
  style.ItemInnerSpacing = {6.0F, 4.0F};
  style.IndentSpacing = 14.0F;
  style.ScrollbarSize = 11.0F;
  style.GrabMinSize = 5.0F;
  style.WindowRounding = 0.0F;
  style.PopupRounding = 6.0F;
  style.FrameRounding = 5.0F;
  style.GrabRounding = 2.5F;
  style.ScrollbarRounding = 6.0F;
  style.WindowBorderSize = 0.0F;
  style.PopupBorderSize = 1.0F;
  style.FrameBorderSize = 0.0F;
}

void applyColours(ImGuiStyle& style) {
  const Palette& colours = palette();
  const ImVec4 none{0.0F, 0.0F, 0.0F, 0.0F};
  auto& slot = style.Colors;
  slot[ImGuiCol_Text] = colours.text;
  slot[ImGuiCol_TextDisabled] = colours.muted;
  slot[ImGuiCol_WindowBg] = colours.panel;
  slot[ImGuiCol_ChildBg] = none;
  slot[ImGuiCol_PopupBg] = colours.popup;
  slot[ImGuiCol_Border] = colours.line;
  slot[ImGuiCol_FrameBg] = colours.field;
  slot[ImGuiCol_FrameBgHovered] = colours.fieldHovered;
  slot[ImGuiCol_FrameBgActive] = colours.fieldActive;
  slot[ImGuiCol_ScrollbarBg] = none;
  slot[ImGuiCol_ScrollbarGrab] = colours.buttonHovered;
  slot[ImGuiCol_ScrollbarGrabHovered] = colours.buttonActive;
  slot[ImGuiCol_ScrollbarGrabActive] = colours.muted;
  slot[ImGuiCol_CheckMark] = colours.accent;
  slot[ImGuiCol_SliderGrab] = colours.accent;
  slot[ImGuiCol_SliderGrabActive] = colours.accentHovered;
  slot[ImGuiCol_Button] = colours.button;
  slot[ImGuiCol_ButtonHovered] = colours.buttonHovered;
  slot[ImGuiCol_ButtonActive] = colours.buttonActive;
  slot[ImGuiCol_Header] = none;
  slot[ImGuiCol_HeaderHovered] = colours.heading;
  slot[ImGuiCol_HeaderActive] = colours.headingActive;
  slot[ImGuiCol_Separator] = colours.line;
  slot[ImGuiCol_TextSelectedBg] = colours.selected;
  slot[ImGuiCol_NavHighlight] = colours.accent;
}

/// The palettes, in the order of themes().
const std::array<Palette, 2>& palettes() {
  static const std::array<Palette, 2> list{{
      {
          .text = rgb(0xE8EAEE),
          .muted = rgb(0xA3ACBB),
          .accent = rgb(0x6FB3FA),
          .accentFill = rgb(0x34557C),
          .accentHovered = rgb(0x406999),
          .panel = rgb(0x1B1E25),
          .overlay = rgb(0x21252E),
          .popup = rgb(0x242933),
          .field = rgb(0x292E38),
          .fieldHovered = rgb(0x343B49),
          .fieldActive = rgb(0x3A4252),
          .button = rgb(0x2F3541),
          .buttonHovered = rgb(0x3A4252),
          .buttonActive = rgb(0x465064),
          .heading = rgb(0x2B303B),
          .headingActive = rgb(0x333A47),
          .line = rgb(0x323844),
          .selected = rgb(0x3D6FA8, 0.7F),
          .good = rgb(0x7CC58E),
          .warning = rgb(0xEDBB5F),
          .error = rgb(0xF58A84),
          .ghost = rgb(0x63D08A),
          .plot = {rgb(0x6FB3FA), rgb(0xF2A65A), rgb(0xC792EA), rgb(0xF2F4F8), rgb(0xF06A8A)},
      },
      {
          .text = rgb(0x1B1F26),
          .muted = rgb(0x535D6C),
          .accent = rgb(0x1666BE),
          .accentFill = rgb(0xA9CBF1),
          .accentHovered = rgb(0x8FBBEB),
          .panel = rgb(0xF1F3F6),
          .overlay = rgb(0xFAFBFC),
          .popup = rgb(0xFFFFFF),
          .field = rgb(0xDDE2E9),
          .fieldHovered = rgb(0xD1D8E2),
          .fieldActive = rgb(0xC6CFDB),
          .button = rgb(0xDBE0E8),
          .buttonHovered = rgb(0xCBD3DE),
          .buttonActive = rgb(0xB9C4D3),
          .heading = rgb(0xE2E7EE),
          .headingActive = rgb(0xD5DCE6),
          .line = rgb(0xC4CCD7),
          .selected = rgb(0x8FBBEB, 0.8F),
          .good = rgb(0x1F7A3F),
          .warning = rgb(0x8F5200),
          .error = rgb(0xB3261E),
          .ghost = rgb(0x17803F),
          .plot = {rgb(0x1666BE), rgb(0xB85A08), rgb(0x7D3FBF), rgb(0x2A303A), rgb(0xC02B55)},
      },
  }};
  return list;
}

}  // namespace

const Palette& palette() {
  const auto* chosen = static_cast<const Palette*>(ImGui::GetIO().UserData);
  return chosen == nullptr ? palettes().front() : *chosen;
}

void applyTheme(ImGuiStyle& style, Theme theme, float scale) {
  // ImGui keeps this pointer with the context, so that there is no global state besides it.
  ImGui::GetIO().UserData = const_cast<Palette*>(&palettes()[static_cast<std::size_t>(theme)]);  // NOLINT
  style = ImGuiStyle();
  applySizes(style);
  applyColours(style);
  style.ScaleAllSizes(scale);
}

UiFonts buildFonts(ImFontAtlas& atlas, float scale, float density) {
  // Latin, Greek, Cyrillic and general punctuation, for file names and units.
  static constexpr std::array<ImWchar, 15> ranges{0x0020, 0x017F, 0x0370, 0x03FF, 0x0400, 0x04FF, 0x2010, 0x2027,
                                                  0x2070, 0x209F, 0x2190, 0x2193, 0x2212, 0x2212, 0};
  const std::string_view bytes = embeddedFonts().front().bytes;
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 2;
  const auto add = [&](float size) {
    // The atlas frees its copy; it does not own the embedded bytes.
    void* copy = ImGui::MemAlloc(bytes.size());
    std::memcpy(copy, bytes.data(), bytes.size());
    return atlas.AddFontFromMemoryTTF(copy, static_cast<int>(bytes.size()), std::round(size * scale * density), &config,
                                      ranges.data());
  };
  atlas.Clear();
  atlas.TexGlyphPadding = 1;
  const UiFonts fonts{.regular = add(baseFontSize), .title = add(baseFontSize * 1.3F)};
  atlas.Build();
  return fonts;
}

}  // namespace drape::ui
