package org.phrenic.scene.style;

import java.util.Collections;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * How a scene is drawn.
 *
 * @param appearances look of each structure by name; one that is not named is not drawn
 * @param background behind it
 * @param restWireframe edges of the rest shape of what deforms, over the shape of now
 * @param field quantity shown in colours
 * @param fieldStructure structure that shows it; empty for none
 * @param scale colours of the field
 * @param overlays what is drawn over the surfaces
 * @param clip plane that cuts the body open
 * @param transparency how to look through
 * @param samples samples a pixel, 0 for no smoothing of edges; the driver's most is the most that is taken
 * @param highlighted structure that stands out; empty for none
 */
public record SceneStyle(
        Map<String, Appearance> appearances,
        SceneBackground background,
        boolean restWireframe,
        ColourField field,
        String fieldStructure,
        ColourScale scale,
        Set<Overlay.Kind> overlays,
        Optional<ClipPlane> clip,
        Transparency transparency,
        int samples,
        String highlighted) {
    private static final double DEFAULT_RANGE_MM = 15;

    public SceneStyle {
        appearances = Collections.unmodifiableMap(new LinkedHashMap<>(appearances));
        Set<Overlay.Kind> kinds = EnumSet.noneOf(Overlay.Kind.class);
        kinds.addAll(overlays);
        overlays = Collections.unmodifiableSet(kinds);
    }

    /** Every surface in the colours of an anatomy atlas, the skin clear. */
    public static SceneStyle atlas(List<Surface> surfaces) {
        Map<String, Appearance> looks = new LinkedHashMap<>();
        surfaces.forEach(s -> looks.put(s.name(), SurfaceMaterial.of(s.kind()).appearance()));
        return new SceneStyle(
                looks,
                SceneBackground.LIGHT,
                false,
                ColourField.NONE,
                "",
                ColourScale.sequential(DEFAULT_RANGE_MM, ColourField.DISPLACEMENT.unit()),
                Set.of(),
                Optional.empty(),
                Transparency.TWO_PASS,
                0,
                "");
    }

    /** Look of a structure, if it has one. */
    public Optional<Appearance> appearance(String structure) {
        return Optional.ofNullable(appearances.get(structure));
    }

    /** Whether a structure shows a quantity in colours. */
    public boolean showsField(String structure) {
        return field != ColourField.NONE && structure.equals(fieldStructure);
    }

    public SceneStyle withAppearances(Map<String, Appearance> changed) {
        return edited(draft -> draft.appearances = changed);
    }

    public SceneStyle withAppearance(String structure, Appearance look) {
        Map<String, Appearance> changed = new LinkedHashMap<>(appearances);
        changed.put(structure, look);
        return withAppearances(changed);
    }

    public SceneStyle withBackground(SceneBackground behind) {
        return edited(draft -> draft.background = behind);
    }

    public SceneStyle withRestWireframe(boolean shown) {
        return edited(draft -> draft.restWireframe = shown);
    }

    /** Shows a quantity on a structure. */
    public SceneStyle withField(ColourField quantity, String structure, ColourScale colours) {
        return edited(draft -> {
            draft.field = quantity;
            draft.fieldStructure = structure;
            draft.scale = colours;
        });
    }

    public SceneStyle withScale(ColourScale colours) {
        return edited(draft -> draft.scale = colours);
    }

    public SceneStyle withOverlays(Set<Overlay.Kind> shown) {
        return edited(draft -> draft.overlays = shown);
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
        return edited(draft -> draft.clip = plane);
    }

    public SceneStyle withTransparency(Transparency way) {
        return edited(draft -> draft.transparency = way);
    }

    public SceneStyle withSamples(int count) {
        return edited(draft -> draft.samples = count);
    }

    public SceneStyle withHighlighted(String structure) {
        return edited(draft -> draft.highlighted = structure);
    }

    private SceneStyle edited(Consumer<Draft> change) {
        Draft draft = new Draft(this);
        change.accept(draft);
        return draft.style();
    }

    /** A style being changed: the one place where all of its parts are handed on. */
    private static final class Draft {
        private Map<String, Appearance> appearances;
        private SceneBackground background;
        private boolean restWireframe;
        private ColourField field;
        private String fieldStructure;
        private ColourScale scale;
        private Set<Overlay.Kind> overlays;
        private Optional<ClipPlane> clip;
        private Transparency transparency;
        private int samples;
        private String highlighted;

        Draft(SceneStyle of) {
            appearances = of.appearances;
            background = of.background;
            restWireframe = of.restWireframe;
            field = of.field;
            fieldStructure = of.fieldStructure;
            scale = of.scale;
            overlays = of.overlays;
            clip = of.clip;
            transparency = of.transparency;
            samples = of.samples;
            highlighted = of.highlighted;
        }

        SceneStyle style() {
            return new SceneStyle(
                    appearances,
                    background,
                    restWireframe,
                    field,
                    fieldStructure,
                    scale,
                    overlays,
                    clip,
                    transparency,
                    samples,
                    highlighted);
        }
    }
}
