package org.phrenic.cli.option;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.StructureSelection;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;
import picocli.CommandLine.Option;

/** Options for the style of a scene. */
public final class StyleOptions {
    /** All options. */
    public static final Set<String> NAMES = Set.of(
            "--field",
            "--reference",
            "--range",
            "--rest-wireframe",
            "--hide",
            "--show",
            "--only",
            "--background",
            "--clip",
            "--overlay");

    private static final double DISPLACEMENT_MM = 20;
    private static final double STRAIN_PERCENT = 20;
    private static final double FARTHEST_CLIP_MM = 1e5;
    private static final String CLIP_SIDES = "LRAPSI";
    /** Plane normals of these sides, LPS. */
    private static final double[][] CLIP_NORMALS = {{1, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}
    };

    private static final String DIAPHRAGM = "diaphragm";

    @Option(
            names = "--field",
            paramLabel = "NAME",
            description = "Colours on the diaphragm: displacement (mm), strain (change of area, %%) or distance from "
                    + "--reference (mm).")
    private String field;

    @Option(names = "--reference", paramLabel = "MESH", description = "Surface that --field distance is measured from.")
    private Path reference;

    @Option(names = "--range", paramLabel = "MIN:MAX", description = "Range of the colours of --field.")
    private String range;

    @Option(names = "--rest-wireframe", description = "The shape at rest as a wireframe over what moves.")
    private boolean restWireframe;

    @Option(
            names = "--hide",
            paramLabel = "NAME",
            description = "Leave out a structure (rib_05_R) or a kind (skin); may be repeated.")
    private List<String> hidden = new ArrayList<>();

    @Option(names = "--show", paramLabel = "NAME", description = "Show what --only left out; may be repeated.")
    private List<String> shown = new ArrayList<>();

    @Option(names = "--only", paramLabel = "NAME", description = "Show nothing else; may be repeated.")
    private List<String> only = new ArrayList<>();

    @Option(names = "--background", paramLabel = "NAME", description = "light or dark.")
    private String background = "light";

    @Option(
            names = "--clip",
            paramLabel = "SIDE:MM",
            description = "Cut away what lies farther to a side than so many mm: A:20, L:0, S:1250 (L R A P S I).")
    private String clip;

    @Option(
            names = "--overlay",
            paramLabel = "NAME",
            description = "springs, rigid-links, attachments, fibres, action-lines, helical-axes; may be repeated.")
    private List<String> overlays = new ArrayList<>();

    /** Checks, before any computation, all values that do not depend on the body. */
    public void validate() {
        boolean distance = colourField() == ColourField.DISTANCE;
        if (distance && reference == null) {
            throw new BadInputException("--field distance: found no --reference, expected a surface to measure from");
        }
        if (!distance && reference != null) {
            throw new BadInputException(
                    "--reference " + reference + ": found no --field distance, expected both or neither");
        }
        scale();
        sceneBackground();
        clipPlane();
        overlayKinds();
    }

    /** Reference surface of the distance field; empty if none is given. */
    public Optional<TriangleMesh> reference() {
        return Optional.ofNullable(reference).map(MeshFiles::read);
    }

    public SceneStyle style(List<Surface> surfaces) {
        StructureSelection selection = new StructureSelection(surfaces);
        SceneStyle style = SceneStyle.atlas(surfaces)
                .withBackground(sceneBackground())
                .withRestWireframe(restWireframe)
                .withOverlays(overlayKinds())
                .withClip(clipPlane())
                .withTransparency(Transparency.TWO_PASS)
                .withSamples(SceneStyle.SMOOTH_SAMPLES);
        if (!only.isEmpty()) {
            for (String name : style.appearances().keySet()) {
                style = selection.withVisibility(style, name, false);
            }
        }
        style = visible("--only", only, selection, style, true);
        style = visible("--show", shown, selection, style, true);
        style = visible("--hide", hidden, selection, style, false);
        return colourField() == ColourField.NONE ? style : style.withField(colourField(), DIAPHRAGM, scale());
    }

    private static SceneStyle visible(
            String option, List<String> words, StructureSelection selection, SceneStyle style, boolean visible) {
        SceneStyle changed = style;
        for (String word : words) {
            try {
                changed = selection.withVisibility(changed, word, visible);
            } catch (IllegalArgumentException none) {
                throw new BadInputException(option + ": " + none.getMessage(), none);
            }
        }
        return changed;
    }

    private ColourField colourField() {
        List<ColourField> offered = List.of(ColourField.DISPLACEMENT, ColourField.STRAIN, ColourField.DISTANCE);
        return field == null ? ColourField.NONE : OptionValues.choice("--field", field, offered);
    }

    private ColourScale scale() {
        ColourScale usual = colourField() == ColourField.STRAIN
                ? ColourScale.diverging(STRAIN_PERCENT, ColourField.STRAIN.unit())
                : ColourScale.sequential(DISPLACEMENT_MM, ColourField.DISPLACEMENT.unit());
        if (range == null) {
            return usual;
        }
        if (field == null) {
            throw new BadInputException(
                    "--range " + range + ": found no --field, expected displacement, strain or distance");
        }
        return OptionValues.range("--range", range, usual);
    }

    private SceneBackground sceneBackground() {
        return OptionValues.choice("--background", background, List.of(SceneBackground.values()));
    }

    private Optional<ClipPlane> clipPlane() {
        if (clip == null) {
            return Optional.empty();
        }
        int side = clip.indexOf(':') == 1 ? CLIP_SIDES.indexOf(Character.toUpperCase(clip.charAt(0))) : -1;
        if (side < 0) {
            throw new BadInputException(
                    "--clip: found '" + clip + "', expected a side of L R A P S I and a distance in mm such as A:20");
        }
        double mm = OptionValues.number("--clip " + clip, clip.substring(2));
        if (Math.abs(mm) > FARTHEST_CLIP_MM) {
            throw new BadInputException("--clip: found " + clip.substring(2) + " mm, expected -100000 to 100000 mm");
        }
        double[] normal = CLIP_NORMALS[side];
        return Optional.of(new ClipPlane(normal[0], normal[1], normal[2], mm));
    }

    private Set<Overlay.Kind> overlayKinds() {
        Set<Overlay.Kind> kinds = new LinkedHashSet<>();
        overlays.forEach(label -> kinds.add(OptionValues.choice("--overlay", label, List.of(Overlay.Kind.values()))));
        return kinds;
    }
}
