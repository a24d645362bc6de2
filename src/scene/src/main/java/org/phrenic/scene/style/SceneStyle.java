package org.phrenic.scene.style;

import java.util.Collections;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiFunction;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * Style of a scene: appearance of each structure, background, colouring, lines, clip plane and quality.
 *
 * @param appearances appearance by structure name; a structure without an entry is not drawn
 * @param background background of the picture
 * @param colouring quantity shown in colours
 * @param lines lines and points drawn over the surfaces
 * @param clip plane that cuts the body open
 * @param quality transparency method and antialiasing
 * @param highlighted name of the highlighted structure; empty for none
 */
public record SceneStyle(
        Map<String, Appearance> appearances,
        SceneBackground background,
        Colouring colouring,
        Lines lines,
        Optional<ClipPlane> clip,
        Quality quality,
        String highlighted) {
    /** Samples of a pixel where edges are to be smooth: in picture files, on a graphics card, in a view at rest. */
    public static final int SMOOTH_SAMPLES = 4;

    private static final double DEFAULT_RANGE_MM = 15;

    /**
     * A quantity shown in colours on one structure.
     *
     * @param structure name of the coloured structure; empty for none
     */
    public record Colouring(ColourField field, String structure, ColourScale scale) {}

    /** @param restWireframe whether the rest shape is drawn as a wireframe over the current shape */
    public record Lines(Set<Overlay.Kind> overlays, boolean restWireframe) {
        public Lines {
            overlays = Collections.unmodifiableSet(new TreeSet<>(overlays));
        }
    }

    /**
     * Effort of drawing.
     *
     * @param samples samples per pixel, 0 for no antialiasing; limited to the maximum of the driver
     * @param resolution drawn over shown pixels along each side, at most 1; heeded without antialiasing and peeling
     */
    public record Quality(Transparency transparency, int samples, double resolution) {
        /** @throws IllegalArgumentException if the resolution is not above 0 and at most 1 */
        public Quality {
            if (!(resolution > 0 && resolution <= 1)) {
                throw new IllegalArgumentException("resolution: found " + resolution + ", expected above 0, at most 1");
            }
        }
    }

    public SceneStyle {
        appearances = Collections.unmodifiableMap(new LinkedHashMap<>(appearances));
    }

    /** A style with all surfaces in the colours of an anatomy atlas and translucent skin. */
    public static SceneStyle atlas(List<Surface> surfaces) {
        Map<String, Appearance> appearances = new LinkedHashMap<>();
        surfaces.forEach(s ->
                appearances.put(s.name(), SurfaceMaterial.of(s.kind(), s.name()).appearance()));
        ColourScale scale = ColourScale.sequential(DEFAULT_RANGE_MM, ColourField.DISPLACEMENT.unit());
        return new SceneStyle(
                appearances,
                SceneBackground.LIGHT,
                new Colouring(ColourField.NONE, "", scale),
                new Lines(Set.of(), false),
                Optional.empty(),
                new Quality(Transparency.TWO_PASS, 0, 1),
                "");
    }

    /** Appearance of a structure; empty if it has none. */
    public Optional<Appearance> appearance(String structure) {
        return Optional.ofNullable(appearances.get(structure));
    }

    public boolean shows(String structure) {
        return appearance(structure).filter(Appearance::visible).isPresent();
    }

    /** The visible ones of some surfaces. */
    public List<Surface> visible(List<Surface> surfaces) {
        return surfaces.stream().filter(s -> shows(s.name())).toList();
    }

    /** Whether a structure shows a quantity in colours. */
    public boolean showsField(String structure) {
        return field() != ColourField.NONE && structure.equals(colouring.structure);
    }

    public ColourField field() {
        return colouring.field;
    }

    public ColourScale scale() {
        return colouring.scale;
    }

    public SceneStyle withAppearances(Map<String, Appearance> changed) {
        return new SceneStyle(changed, background, colouring, lines, clip, quality, highlighted);
    }

    /** Changes the appearance of each given surface that has one. */
    public SceneStyle withAppearances(List<Surface> surfaces, BiFunction<Surface, Appearance, Appearance> change) {
        Map<String, Appearance> changed = new LinkedHashMap<>(appearances);
        surfaces.forEach(s -> changed.computeIfPresent(s.name(), (name, usual) -> change.apply(s, usual)));
        return withAppearances(changed);
    }

    public SceneStyle withAppearance(String structure, Appearance appearance) {
        Map<String, Appearance> changed = new LinkedHashMap<>(appearances);
        changed.put(structure, appearance);
        return withAppearances(changed);
    }

    public SceneStyle withBackground(SceneBackground behind) {
        return new SceneStyle(appearances, behind, colouring, lines, clip, quality, highlighted);
    }

    /** Shows a quantity on a structure. */
    public SceneStyle withField(ColourField quantity, String structure, ColourScale colours) {
        Colouring changed = new Colouring(quantity, structure, colours);
        return new SceneStyle(appearances, background, changed, lines, clip, quality, highlighted);
    }

    private SceneStyle with(Lines changed) {
        return new SceneStyle(appearances, background, colouring, changed, clip, quality, highlighted);
    }

    public SceneStyle withRestWireframe(boolean shown) {
        return with(new Lines(lines.overlays, shown));
    }

    public SceneStyle withOverlays(Set<Overlay.Kind> shown) {
        return with(new Lines(shown, lines.restWireframe));
    }

    public SceneStyle withOverlay(Overlay.Kind kind, boolean shown) {
        Set<Overlay.Kind> changed = EnumSet.of(kind);
        changed.addAll(lines.overlays);
        if (!shown) {
            changed.remove(kind);
        }
        return withOverlays(changed);
    }

    public SceneStyle withClip(Optional<ClipPlane> plane) {
        return new SceneStyle(appearances, background, colouring, lines, plane, quality, highlighted);
    }

    private SceneStyle with(Quality changed) {
        return new SceneStyle(appearances, background, colouring, lines, clip, changed, highlighted);
    }

    public SceneStyle withTransparency(Transparency way) {
        return with(new Quality(way, quality.samples, quality.resolution));
    }

    public SceneStyle withSamples(int count) {
        return with(new Quality(quality.transparency, count, quality.resolution));
    }

    /** Draws fewer pixels than are shown. */
    public SceneStyle withResolution(double drawnOverShown) {
        return with(new Quality(quality.transparency, quality.samples, drawnOverShown));
    }

    public SceneStyle withHighlighted(String structure) {
        return new SceneStyle(appearances, background, colouring, lines, clip, quality, structure);
    }
}
