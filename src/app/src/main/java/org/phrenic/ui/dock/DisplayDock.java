package org.phrenic.ui.dock;

import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourMap;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.StructureLabels;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.LatestTask;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.FileDialogs;
import org.phrenic.ui.widget.ScrollablePanel;
import org.phrenic.ui.widget.TypedText;

/**
 * What else is shown: overlays of the model, the rest shape, a field as colours, a clip plane, order-independent
 * transparency.
 */
public final class DisplayDock extends ScrollablePanel implements Session.Listener {
    private static final int SLIDER_MAX = 1000;
    private static final int RANGE_DIGITS = 9;
    /** Distance of the ends of the clip plane's way from the surfaces at rest, mm: a deep breath moves them by 30. */
    private static final double CLIP_MARGIN_MM = 50;

    private static final List<ColourField> FIELDS =
            List.of(ColourField.NONE, ColourField.DISPLACEMENT, ColourField.STRAIN, ColourField.DISTANCE);

    private record StructureItem(String structure, String name) {
        @Override
        public String toString() {
            return name;
        }
    }

    private final transient Session session;
    private final transient AppearanceModel appearance;
    private final transient Supplier<Optional<Path>> chooser;
    private final JComboBox<String> field = Controls.describe(
            new JComboBox<>(new String[] {
                "No colours", ColourField.DISPLACEMENT.label(), ColourField.STRAIN.label(), "Distance to a surface"
            }),
            "Colours show",
            "What the colours show");
    private final JButton reference;
    /** Names the surface that is measured from. */
    private String referenceText = "Surface...";

    private final transient LatestTask reading = new LatestTask();
    private final JComboBox<StructureItem> structure = Controls.describe(
            new JComboBox<>(), "Coloured structure", "Structure that carries the colours and the shape at rest");
    private final JTextField minimum =
            Controls.describe(new JTextField("0", 4), "Least value of the colours", "Value of the first colour");
    private final JTextField maximum =
            Controls.describe(new JTextField("20", 4), "Greatest value of the colours", "Value of the last colour");
    private final JLabel unit = new JLabel("mm");
    private final JComboBox<ClipSide> clip =
            Controls.describe(new JComboBox<>(ClipSide.values()), "Clip plane", "Cut away what lies beyond a plane");
    private final JSlider clipSlider = Controls.describe(
            Controls.slider(0, SLIDER_MAX, SLIDER_MAX / 2), "Place of the clip plane", "Where the plane is");
    private final JComboBox<String> sorting = Controls.describe(
            new JComboBox<>(new String[] {"Fast", "Sorted for each pixel"}),
            "Quality of translucency",
            "Sorted is right for organs within organs, and takes longer");
    private final JCheckBox rest = Controls.describe(
            new JCheckBox("Shape at rest"),
            "Shape at rest",
            "The shape at end-expiration as a wireframe over the coloured structure");
    private final transient Map<Overlay.Kind, JCheckBox> overlays = new EnumMap<>(Overlay.Kind.class);
    private transient double[] bounds = new double[6];
    private transient SceneStyle shown;
    private boolean following;

    public DisplayDock(Session session, AppearanceModel appearance) {
        this(session, appearance, null);
    }

    /** @param chooser asks for the surface from which distances are measured; null for a dialog */
    DisplayDock(Session session, AppearanceModel appearance, Supplier<Optional<Path>> chooser) {
        super(new MigLayout("insets 6 8 8 8, gap 6 3, wrap 1, novisualpadding", "[grow, fill]", ""));
        this.session = session;
        this.appearance = appearance;
        String[] readable = MeshFiles.READABLE.toArray(String[]::new);
        this.chooser = chooser == null ? () -> FileDialogs.open(this, "Surface to measure from", readable) : chooser;
        reference = Controls.button(
                referenceText,
                "Surface from which distances are measured, such as the same organ in a scan (LPS, mm)",
                () -> this.chooser.get().ifPresent(this::readReference));
        setName("show");
        addOverlays();
        addColours();
        addHeading("Clip plane");
        clipSlider.setEnabled(false);
        clip.addActionListener(e -> applyClipPlane());
        clipSlider.addChangeListener(e -> applyClipPlane());
        add(clip, "wmin 0");
        add(clipSlider, "wmin 40");
        addHeading("Translucency");
        sorting.addActionListener(e -> change(style ->
                style.withTransparency(sorting.getSelectedIndex() == 0 ? Transparency.TWO_PASS : Transparency.PEELED)));
        add(sorting, "wmin 0");
        shown = appearance.chosenStyle();
        appearance.addListener(this::followStyle);
        session.addListener(this);
    }

    /** Changes the style, unless the controls follow it. */
    private void change(UnaryOperator<SceneStyle> how) {
        if (!following) {
            appearance.changeStyle(how);
        }
    }

    /** Shows a style that was changed elsewhere. */
    private void followStyle() {
        SceneStyle before = shown;
        SceneStyle now = appearance.chosenStyle();
        shown = now;
        following = true;
        overlays.forEach((kind, box) -> box.setSelected(now.lines().overlays().contains(kind)));
        rest.setSelected(now.lines().restWireframe());
        select(sorting, now.quality().transparency() == Transparency.TWO_PASS ? 0 : 1);
        if (now.clip().isEmpty()) {
            select(clip, 0);
        }
        // Without a surface to measure from, distances are chosen before they are shown.
        if (now.field() != before.field()) {
            select(field, FIELDS.indexOf(now.field()));
        }
        following = false;
    }

    private static void select(JComboBox<?> box, int index) {
        if (box.getSelectedIndex() != index) {
            box.setSelectedIndex(index);
        }
    }

    private void addOverlays() {
        addHeading("Over the surfaces");
        addOverlay(Overlay.Kind.SPRINGS, "Springs", "Springs between nodes");
        addOverlay(Overlay.Kind.RIGID_LINKS, "Rigid links", "Links of constant length between the faces of the sheet");
        addOverlay(Overlay.Kind.ATTACHMENTS, "Attachments", "Nodes attached to bone");
        addOverlay(Overlay.Kind.FIBRES, "Fibres", "Edges along the muscle's fibres");
        addOverlay(Overlay.Kind.ACTION_LINES, "Action lines", "Lines of muscle force of the paper's material");
        addOverlay(Overlay.Kind.HELICAL_AXES, "Helical axes", "Axes about which ribs and sternum turn");
        rest.addActionListener(e -> change(style -> style.withRestWireframe(rest.isSelected())));
        add(rest);
    }

    private void addOverlay(Overlay.Kind kind, String label, String tip) {
        JCheckBox box = Controls.describe(new JCheckBox(label), label, tip);
        box.addActionListener(e -> change(style -> style.withOverlay(kind, box.isSelected())));
        overlays.put(kind, box);
        add(box);
    }

    private void addColours() {
        Controls.describe(reference, "Surface to measure from", reference.getToolTipText());
        reference.setVisible(false);
        structure.addActionListener(e -> applyColours());
        field.addActionListener(e -> onFieldSelected());
        for (JTextField end : List.of(minimum, maximum)) {
            TypedText.onTaken(end, this::applyRange);
        }
        JPanel range = new JPanel(new MigLayout("insets 0, gap 4", "[][grow, fill, 30::]0[]4[grow, fill, 30::][]", ""));
        range.add(new JLabel("Range"));
        range.add(minimum);
        range.add(new JLabel(" to"));
        range.add(maximum);
        range.add(unit);
        addHeading("Colours on");
        add(structure, "wmin 0");
        add(field, "wmin 0");
        add(reference, "wmin 0, hidemode 3");
        add(range);
    }

    private void addHeading(String text) {
        add(Controls.heading(text), getComponentCount() == 0 ? "" : "gaptop 8");
    }

    @Override
    public void onScene(LiveScene scene) {
        bounds = Surface.bounds(scene.surfaces());
        Object before = structure.getSelectedItem();
        structure.removeAllItems();
        scene.surfaces().stream()
                .filter(surface -> surface.motion() == Surface.Motion.DEFORMING)
                .forEach(surface -> structure.addItem(new StructureItem(surface.name(), StructureLabels.of(surface))));
        if (before != null) {
            structure.setSelectedItem(before);
        }
        if (clip.getSelectedIndex() > 0) {
            applyClipPlane();
        }
    }

    private ColourField selectedField() {
        return FIELDS.get(field.getSelectedIndex());
    }

    private void onFieldSelected() {
        ColourField selected = selectedField();
        boolean strain = selected == ColourField.STRAIN;
        minimum.setText(strain ? "-30" : "0");
        maximum.setText(strain ? "30" : "20");
        unit.setText(strain ? "%" : "mm");
        reference.setVisible(selected == ColourField.DISTANCE);
        if (!following
                && selected == ColourField.DISTANCE
                && appearance.reference().isEmpty()) {
            chooser.get().ifPresentOrElse(this::readReference, this::showFormerColours);
        } else {
            applyColours();
        }
    }

    /** Reads the surface to measure from; the one that was chosen last counts. */
    private void readReference(Path file) {
        reference.setText("Reading " + file.getFileName());
        reading.execute(
                () -> new DistanceField(MeshFiles.read(file)),
                surface -> {
                    referenceText = file.getFileName() + "...";
                    reference.setText(referenceText);
                    appearance.setReference(surface);
                    applyColours();
                },
                sentence -> {
                    reference.setText(referenceText);
                    if (selectedField() == ColourField.DISTANCE
                            && appearance.reference().isEmpty()) {
                        showFormerColours();
                    }
                    session.refuse(sentence);
                });
    }

    /** Goes back to the colours that are shown, where there is no surface to measure from. */
    private void showFormerColours() {
        ColourScale range = shown.scale();
        field.setSelectedIndex(FIELDS.indexOf(shown.field()));
        minimum.setText(NumberFormats.format(range.min(), RANGE_DIGITS));
        maximum.setText(NumberFormats.format(range.max(), RANGE_DIGITS));
        applyColours();
    }

    /** Takes the range that was typed, or says why not. */
    private void applyRange() {
        applyColours().filter(sentence -> !following).ifPresent(session::refuse);
    }

    /** Applies what is chosen; returns why the range cannot be used, empty if it can. */
    private Optional<String> applyColours() {
        boolean unmeasured = selectedField() == ColourField.DISTANCE
                && appearance.reference().isEmpty();
        ColourField coloured = unmeasured ? ColourField.NONE : selectedField();
        Optional<ColourScale> scale = scale(coloured);
        Optional<String> problem = scale.isPresent()
                ? Optional.empty()
                : Optional.of("Range of the colours: found '" + minimum.getText() + "' to '" + maximum.getText()
                        + "', expected two numbers, the smaller first; the former range stays.");
        Controls.mark(minimum, problem);
        Controls.mark(maximum, problem);
        StructureItem chosen = (StructureItem) structure.getSelectedItem();
        if (chosen != null) {
            scale.ifPresent(s -> change(style -> style.withField(coloured, chosen.structure(), s)));
        }
        return problem;
    }

    private Optional<ColourScale> scale(ColourField coloured) {
        String in = unit.getText();
        double from = NumberFormats.parse(minimum.getText(), in).orElse(Double.NaN);
        double to = NumberFormats.parse(maximum.getText(), in).orElse(Double.NaN);
        ColourMap map = coloured == ColourField.STRAIN ? ColourMap.COOL_WARM : ColourMap.VIRIDIS;
        return ColourScale.rangeProblem(from, to).isPresent()
                ? Optional.empty()
                : Optional.of(new ColourScale(map, from, to, in));
    }

    /** Sets the clip plane: at the left end of the slider nothing is cut away, at the right end everything. */
    private void applyClipPlane() {
        ClipSide selected = (ClipSide) clip.getSelectedItem();
        clipSlider.setEnabled(selected != ClipSide.NONE);
        if (selected == ClipSide.NONE) {
            change(style -> style.withClip(Optional.empty()));
            return;
        }
        double removed = clipSlider.getValue() / (double) SLIDER_MAX;
        double share = selected.forwards() ? removed : 1 - removed;
        double low = bounds[selected.axis()] - CLIP_MARGIN_MM;
        double place = low + share * (bounds[3 + selected.axis()] + CLIP_MARGIN_MM - low);
        clipSlider.setToolTipText(Numbers.format("Where the plane is: %.0f mm", place));
        Controls.tellValue(clipSlider, Numbers.format("%.0f mm", place));
        ClipPlane plane = selected.plane(place);
        change(style -> style.withClip(Optional.of(plane)));
    }
}
