package org.phrenic.ui.dock;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.StructureLabels;
import org.phrenic.scene.style.Transparency;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.widget.FileDialogs;
import org.phrenic.ui.widget.ScrollablePanel;

/**
 * What else is shown: parts of the model over the surfaces, the shape at rest, colours on a surface, a clip plane, and
 * how well translucent surfaces are sorted.
 */
public final class DisplayDock extends ScrollablePanel {
    private static final List<String> AXES = List.of("No clip plane", "From the left", "From the front", "From above");
    private static final int FROM_FRONT = 2;
    private static final int FROM_ABOVE = 3;
    private static final int SLIDER_MAX = 1000;

    /** A structure by its name for people. */
    private record StructureItem(String structure, String name) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static final int STRAIN = 2;
    private static final int DISTANCE = 3;

    private final transient Session session;
    private final transient AppearanceModel appearance;
    private final transient Supplier<Optional<Path>> chooser;
    private final JComboBox<String> field = new JComboBox<>(new String[] {
        "No colours", ColourField.DISPLACEMENT.label(), ColourField.STRAIN.label(), "Distance to a surface"
    });
    private final JButton reference = new JButton("Surface...");
    private final JComboBox<StructureItem> structure = new JComboBox<>();
    private final JTextField minimum = new JTextField("0", 4);
    private final JTextField maximum = new JTextField("20", 4);
    private final JLabel unit = new JLabel("mm");
    private final JComboBox<String> clipAxis = new JComboBox<>(AXES.toArray(new String[0]));
    private final JSlider clipSlider = new JSlider(0, SLIDER_MAX, SLIDER_MAX / 2);
    private transient double[] box = new double[6];

    public DisplayDock(Session session, AppearanceModel appearance) {
        this(session, appearance, null);
    }

    /** @param chooser asks for the surface from which distances are measured; null for the usual dialogue */
    DisplayDock(Session session, AppearanceModel appearance, Supplier<Optional<Path>> chooser) {
        super(new MigLayout("insets 6 8 8 8, gap 6 3, wrap 1, novisualpadding", "[grow, fill]", ""));
        this.session = session;
        this.appearance = appearance;
        this.chooser = chooser == null
                ? () -> FileDialogs.open(this, "Surface to measure from", MeshFiles.READABLE.toArray(new String[0]))
                : chooser;
        setName("show");
        addHeading("Over the surfaces");
        addOverlay(Overlay.Kind.SPRINGS, "Springs", "Springs between nodes");
        addOverlay(Overlay.Kind.RIGID_LINKS, "Rigid links", "Links of constant length between the faces of the sheet");
        addOverlay(Overlay.Kind.ATTACHMENTS, "Attachments", "Nodes that bone holds");
        addOverlay(Overlay.Kind.FIBRES, "Fibres", "Edges along the muscle's fibres");
        addOverlay(Overlay.Kind.ACTION_LINES, "Action lines", "Lines of muscle force of the paper's material");
        addOverlay(Overlay.Kind.HELICAL_AXES, "Helical axes", "Axes about which ribs and sternum turn");
        JCheckBox rest = new JCheckBox("Shape at rest");
        rest.setToolTipText("The shape at end-expiration as a wireframe over the coloured structure");
        rest.addActionListener(e -> appearance.changeStyle(style -> style.withRestWireframe(rest.isSelected())));
        add(withAccessibleName(rest, "Shape at rest"));
        addHeading("Colours on");
        structure.setToolTipText("Structure that carries the colours and the shape at rest");
        add(withAccessibleName(structure, "Coloured structure"), "wmin 0");
        field.setToolTipText("What the colours show");
        add(withAccessibleName(field, "Colours show"), "wmin 0");
        reference.setToolTipText(
                "Surface from which distances are measured, such as the same organ in a scan (LPS, mm)");
        reference.setVisible(false);
        add(withAccessibleName(reference, "Surface to measure from"), "wmin 0, hidemode 3");
        JPanel range = new JPanel(new MigLayout("insets 0, gap 4", "[][grow, fill, 30::]0[]4[grow, fill, 30::][]", ""));
        minimum.setToolTipText("Value of the first colour");
        maximum.setToolTipText("Value of the last colour");
        range.add(new JLabel("Range"));
        range.add(withAccessibleName(minimum, "Least value of the colours"));
        range.add(new JLabel(" to"));
        range.add(withAccessibleName(maximum, "Greatest value of the colours"));
        range.add(unit);
        add(range);
        addHeading("Clip plane");
        clipAxis.setToolTipText("Cut away what lies beyond a plane");
        clipSlider.setToolTipText("Where the plane is");
        add(withAccessibleName(clipAxis, "Clip plane"), "wmin 0");
        add(withAccessibleName(clipSlider, "Place of the clip plane"), "wmin 40");
        addHeading("Translucency");
        JComboBox<String> sorting = new JComboBox<>(new String[] {"Fast", "Sorted for each pixel"});
        sorting.setToolTipText("Sorted is right for organs within organs, and takes longer");
        sorting.addActionListener(e -> appearance.changeStyle(style ->
                style.withTransparency(sorting.getSelectedIndex() == 0 ? Transparency.TWO_PASS : Transparency.PEELED)));
        add(withAccessibleName(sorting, "Quality of translucency"), "wmin 0");
        clipSlider.setEnabled(false);
        addListeners(session);
    }

    private void addListeners(Session session) {
        structure.addActionListener(e -> applyColours());
        field.addActionListener(e -> onFieldSelected());
        reference.addActionListener(e -> chooser.get().ifPresent(this::readReference));
        minimum.addActionListener(e -> applyColours());
        maximum.addActionListener(e -> applyColours());
        clipAxis.addActionListener(e -> applyClipPlane());
        clipSlider.addChangeListener(e -> applyClipPlane());
        session.addListener(new Session.Listener() {
            @Override
            public void onScene(LiveScene scene) {
                onSceneLoaded(scene);
            }
        });
    }

    private void addHeading(String text) {
        JLabel label = new JLabel(text);
        label.putClientProperty("FlatLaf.styleClass", "h4");
        add(label, getComponentCount() == 0 ? "" : "gaptop 8");
    }

    private static <C extends JComponent> C withAccessibleName(C component, String name) {
        component.setName(name);
        component.getAccessibleContext().setAccessibleName(name);
        return component;
    }

    private void addOverlay(Overlay.Kind kind, String label, String tip) {
        JCheckBox box = new JCheckBox(label);
        box.setToolTipText(tip);
        box.addActionListener(e -> appearance.changeStyle(style -> style.withOverlay(kind, box.isSelected())));
        add(withAccessibleName(box, label));
    }

    private void onSceneLoaded(LiveScene scene) {
        box = SceneBounds.of(scene.surfaces());
        Object before = structure.getSelectedItem();
        structure.removeAllItems();
        scene.surfaces().stream()
                .filter(surface -> surface.motion() == Surface.Motion.DEFORMING)
                .forEach(surface -> structure.addItem(new StructureItem(surface.name(), StructureLabels.of(surface))));
        if (before != null) {
            structure.setSelectedItem(before);
        }
    }

    private void onFieldSelected() {
        boolean strain = field.getSelectedIndex() == STRAIN;
        minimum.setText(strain ? "-30" : "0");
        maximum.setText(strain ? "30" : "20");
        unit.setText(strain ? "%" : "mm");
        boolean distance = field.getSelectedIndex() == DISTANCE;
        reference.setVisible(distance);
        if (distance && appearance.reference().isEmpty()) {
            chooser.get().ifPresentOrElse(this::readReference, () -> field.setSelectedIndex(0));
        } else {
            applyColours();
        }
    }

    private void readReference(Path file) {
        String before = reference.getText();
        reference.setText("Reading " + file.getFileName());
        BackgroundWorker.execute(
                () -> new DistanceField(MeshFiles.read(file)),
                surface -> {
                    reference.setText(file.getFileName() + "...");
                    appearance.setReference(surface);
                    applyColours();
                },
                sentence -> {
                    reference.setText(before);
                    if (appearance.reference().isEmpty()) {
                        field.setSelectedIndex(0);
                    }
                    session.refuse(sentence);
                });
    }

    private void applyColours() {
        StructureItem chosen = (StructureItem) structure.getSelectedItem();
        if (chosen == null) {
            return;
        }
        ColourField what =
                switch (field.getSelectedIndex()) {
                    case 1 -> ColourField.DISPLACEMENT;
                    case STRAIN -> ColourField.STRAIN;
                    case DISTANCE -> appearance.reference().isPresent() ? ColourField.DISTANCE : ColourField.NONE;
                    default -> ColourField.NONE;
                };
        Optional<ColourScale> scale = scale(what);
        minimum.putClientProperty("JComponent.outline", scale.isPresent() ? null : "error");
        maximum.putClientProperty("JComponent.outline", scale.isPresent() ? null : "error");
        scale.ifPresent(colours -> appearance.changeStyle(style -> style.withField(what, chosen.structure(), colours)));
    }

    private Optional<ColourScale> scale(ColourField what) {
        try {
            double from = Double.parseDouble(minimum.getText().strip());
            double to = Double.parseDouble(maximum.getText().strip());
            ColourScale scale =
                    what == ColourField.STRAIN ? ColourScale.diverging(1, "%") : ColourScale.sequential(1, "mm");
            return Optional.of(scale.withRange(from, to));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private void applyClipPlane() {
        int which = clipAxis.getSelectedIndex();
        clipSlider.setEnabled(which > 0);
        if (which == 0) {
            appearance.changeStyle(style -> style.withClip(Optional.empty()));
            return;
        }
        // The slider goes from nothing cut away to all of it; from the front it cuts from low y to high.
        double gone = clipSlider.getValue() / (double) SLIDER_MAX;
        int along = which - 1;
        double share = which == FROM_FRONT ? gone : 1 - gone;
        double place = box[along] + share * (box[3 + along] - box[along]);
        clipSlider.setToolTipText(String.format(Locale.ROOT, "Where the plane is: %.0f mm", place));
        ClipPlane plane =
                switch (which) {
                    case FROM_FRONT -> ClipPlane.coronal(place);
                    case FROM_ABOVE -> ClipPlane.axial(place);
                    default -> ClipPlane.sagittal(place);
                };
        appearance.changeStyle(style -> style.withClip(Optional.of(plane)));
    }
}
