package org.phrenic.scene;

import java.util.Collections;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.simulation.Overlay;
import org.phrenic.simulation.Surface;

/**
 * How a scene is drawn.
 *
 * @param looks look of each structure by name; one that is not named is not drawn
 * @param background behind it
 * @param restWireframe edges of the rest shape of what deforms, over the shape of now
 * @param field quantity shown in colours
 * @param fieldOn structure that shows it; empty for none
 * @param scale colours of the field
 * @param overlays what is drawn over the surfaces
 * @param clip plane that cuts the body open
 * @param transparency how to look through
 * @param samples samples a pixel, 0 for no smoothing of edges; the driver's most is the most that is taken
 * @param highlighted structure that stands out; empty for none
 */
public record SceneStyle(
        Map<String, Look> looks,
        Background background,
        boolean restWireframe,
        ColourField field,
        String fieldOn,
        ColourScale scale,
        Set<Overlay.Kind> overlays,
        Optional<ClipPlane> clip,
        Transparency transparency,
        int samples,
        String highlighted) {
    private static final double DEFAULT_RANGE_MM = 15;

    public SceneStyle {
        looks = Collections.unmodifiableMap(new LinkedHashMap<>(looks));
        Set<Overlay.Kind> kinds = EnumSet.noneOf(Overlay.Kind.class);
        kinds.addAll(overlays);
        overlays = Collections.unmodifiableSet(kinds);
    }

    /** Every surface in the colours of an anatomy atlas, the skin clear. */
    public static SceneStyle atlas(List<Surface> surfaces) {
        Map<String, Look> looks = new LinkedHashMap<>();
        surfaces.forEach(s -> looks.put(s.name(), Material.of(s.kind()).look()));
        return new SceneStyle(
                looks,
                Background.LIGHT,
                false,
                ColourField.NONE,
                "",
                ColourScale.magnitude(DEFAULT_RANGE_MM, ColourField.DISPLACEMENT.unit()),
                Set.of(),
                Optional.empty(),
                Transparency.TWO_PASS,
                0,
                "");
    }

    /** Look of a structure, if it has one. */
    public Optional<Look> look(String structure) {
        return Optional.ofNullable(looks.get(structure));
    }

    /** Whether a structure shows a quantity in colours. */
    boolean showsFieldOn(String structure) {
        return field != ColourField.NONE && structure.equals(fieldOn);
    }

    public SceneStyle withLooks(Map<String, Look> changed) {
        return new SceneStyle(
                changed,
                background,
                restWireframe,
                field,
                fieldOn,
                scale,
                overlays,
                clip,
                transparency,
                samples,
                highlighted);
    }

    public SceneStyle withLook(String structure, Look look) {
        Map<String, Look> changed = new LinkedHashMap<>(looks);
        changed.put(structure, look);
        return withLooks(changed);
    }

    public SceneStyle withBackground(Background behind) {
        return new SceneStyle(
                looks,
                behind,
                restWireframe,
                field,
                fieldOn,
                scale,
                overlays,
                clip,
                transparency,
                samples,
                highlighted);
    }

    public SceneStyle withRestWireframe(boolean shown) {
        return new SceneStyle(
                looks, background, shown, field, fieldOn, scale, overlays, clip, transparency, samples, highlighted);
    }

    /** Shows a quantity on a structure. */
    public SceneStyle withField(ColourField quantity, String structure, ColourScale colours) {
        return new SceneStyle(
                looks,
                background,
                restWireframe,
                quantity,
                structure,
                colours,
                overlays,
                clip,
                transparency,
                samples,
                highlighted);
    }

    public SceneStyle withScale(ColourScale colours) {
        return withField(field, fieldOn, colours);
    }

    public SceneStyle withOverlays(Set<Overlay.Kind> shown) {
        return new SceneStyle(
                looks,
                background,
                restWireframe,
                field,
                fieldOn,
                scale,
                shown,
                clip,
                transparency,
                samples,
                highlighted);
    }

    public SceneStyle withOverlay(Overlay.Kind kind, boolean shown) {
        Set<Overlay.Kind> changed = EnumSet.noneOf(Overlay.Kind.class);
        changed.addAll(overlays);
        if (shown) {
            changed.add(kind);
        } else {
            changed.remove(kind);
        }
        return withOverlays(changed);
    }

    public SceneStyle withClip(Optional<ClipPlane> plane) {
        return new SceneStyle(
                looks,
                background,
                restWireframe,
                field,
                fieldOn,
                scale,
                overlays,
                plane,
                transparency,
                samples,
                highlighted);
    }

    public SceneStyle withTransparency(Transparency way) {
        return new SceneStyle(
                looks, background, restWireframe, field, fieldOn, scale, overlays, clip, way, samples, highlighted);
    }

    public SceneStyle withSamples(int count) {
        return new SceneStyle(
                looks,
                background,
                restWireframe,
                field,
                fieldOn,
                scale,
                overlays,
                clip,
                transparency,
                count,
                highlighted);
    }

    public SceneStyle withHighlighted(String structure) {
        return new SceneStyle(
                looks,
                background,
                restWireframe,
                field,
                fieldOn,
                scale,
                overlays,
                clip,
                transparency,
                samples,
                structure);
    }
}
