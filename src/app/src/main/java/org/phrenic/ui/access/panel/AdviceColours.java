package org.phrenic.ui.access.panel;

import java.awt.Color;
import java.util.EnumMap;
import java.util.Map;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.ui.widget.Theme;

/** Green, amber and red of the advice on a path; they differ in lightness too. */
final class AdviceColours {
    private static final Map<PathAdvice.Level, Color> BACKGROUNDS = new EnumMap<>(Map.of(
            PathAdvice.Level.FREE, Theme.colour(0xe2f3f0, 0x17383a),
            PathAdvice.Level.CAREFUL, Theme.colour(0xfff2d6, 0x463510),
            PathAdvice.Level.BARRED, Theme.colour(0xfbe3df, 0x52241e)));
    private static final Map<PathAdvice.Level, Color> TEXTS = new EnumMap<>(Map.of(
            PathAdvice.Level.FREE, Theme.colour(0x0a4a43, 0xc9f0ea),
            PathAdvice.Level.CAREFUL, Theme.colour(0x5c3c00, 0xffe1a3),
            PathAdvice.Level.BARRED, Theme.colour(0x7a1a0e, 0xffd0c8)));

    private AdviceColours() {}

    /** Colour of the path in the 3D view. */
    static Color path(PathAdvice.Level level) {
        return new Color(NeedleMarkers.rgb(level));
    }

    static Color background(PathAdvice.Level level) {
        return BACKGROUNDS.get(level);
    }

    static Color text(PathAdvice.Level level) {
        return TEXTS.get(level);
    }
}
