package org.phrenic.ui;

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
import org.phrenic.format.MeshFiles;
import org.phrenic.scene.ClipPlane;
import org.phrenic.scene.ColourField;
import org.phrenic.scene.ColourScale;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.SceneBounds;
import org.phrenic.scene.StructureNames;
import org.phrenic.scene.Transparency;
import org.phrenic.simulation.Overlay;
import org.phrenic.simulation.Surface;
import org.phrenic.simulation.live.LiveScene;

/** What else is shown: parts of the model over the surfaces, the shape at rest, colours on a surface, a clip plane, and how well translucent surfaces are sorted. */
final class ShowDock extends DockBody {
    private static final List<String> AXES = List.of("No clip plane", "From the left", "From the front", "From above");
    private static final int FROM_FRONT = 2;
    private static final int FROM_ABOVE = 3;
    private static final int WHOLE = 1000;

    /** A structure by its name for people. */
    private record Coloured(String structure, String name) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static final int STRAIN = 2;
    private static final int DISTANCE = 3;

    private final transient Session session;
    private final transient Looks looks;
    private final transient Supplier<Optional<Path>> chooser;
    private final JComboBox<String> field = new JComboBox<>(new String[] {
        "No colours", ColourField.DISPLACEMENT.label(), ColourField.STRAIN.label(), "Distance to a surface"
    });
    private final JButton reference = new JButton("Surface...");
    private final JComboBox<Coloured> structure = new JComboBox<>();
    private final JTextField least = new JTextField("0", 4);
    private final JTextField most = new JTextField("20", 4);
    private final JLabel unit = new JLabel("mm");
    private final JComboBox<String> axis = new JComboBox<>(AXES.toArray(new String[0]));
    private final JSlider cut = new JSlider(0, WHOLE, WHOLE / 2);
    private transient double[] box = new double[6];

    ShowDock(Session session, Looks looks) {
        this(session, looks, null);
    }

    /** @param chooser asks for the surface from which distances are measured; null for the usual dialogue */
    ShowDock(Session session, Looks looks, Supplier<Optional<Path>> chooser) {
        super(new MigLayout("insets 6 8 8 8, gap 6 3, wrap 1, novisualpadding", "[grow, fill]", ""));
        this.session = session;
        this.looks = looks;
        this.chooser = chooser == null
                ? () -> Choosers.open(this, "Surface to measure from", MeshFiles.READABLE.toArray(new String[0]))
                : chooser;
        setName("show");
        heading("Over the surfaces");
        overlay(Overlay.Kind.SPRINGS, "Springs", "Springs between nodes");
        overlay(Overlay.Kind.RIGID_LINKS, "Rigid links", "Links of constant length between the faces of the sheet");
        overlay(Overlay.Kind.ATTACHMENTS, "Attachments", "Nodes that bone holds");
        overlay(Overlay.Kind.FIBRES, "Fibres", "Edges along the muscle's fibres");
        overlay(Overlay.Kind.ACTION_LINES, "Action lines", "Lines of muscle force of the paper's material");
        overlay(Overlay.Kind.HELICAL_AXES, "Helical axes", "Axes about which ribs and sternum turn");
        JCheckBox rest = new JCheckBox("Shape at rest");
        rest.setToolTipText("The shape at end-expiration as a wireframe over the coloured structure");
        rest.addActionListener(e -> looks.change(style -> style.withRestWireframe(rest.isSelected())));
        add(named(rest, "Shape at rest"));
        heading("Colours on");
        structure.setToolTipText("Structure that carries the colours and the shape at rest");
        add(named(structure, "Coloured structure"), "wmin 0");
        field.setToolTipText("What the colours show");
        add(named(field, "Colours show"), "wmin 0");
        reference.setToolTipText(
                "Surface from which distances are measured, such as the same organ in a scan (LPS, mm)");
        reference.setVisible(false);
        add(named(reference, "Surface to measure from"), "wmin 0, hidemode 3");
        JPanel range = new JPanel(new MigLayout("insets 0, gap 4", "[][grow, fill, 30::]0[]4[grow, fill, 30::][]", ""));
        least.setToolTipText("Value of the first colour");
        most.setToolTipText("Value of the last colour");
        range.add(new JLabel("Range"));
        range.add(named(least, "Least value of the colours"));
        range.add(new JLabel(" to"));
        range.add(named(most, "Greatest value of the colours"));
        range.add(unit);
        add(range);
        heading("Clip plane");
        axis.setToolTipText("Cut away what lies beyond a plane");
        cut.setToolTipText("Where the plane is");
        add(named(axis, "Clip plane"), "wmin 0");
        add(named(cut, "Place of the clip plane"), "wmin 40");
        heading("Translucency");
        JComboBox<String> sorting = new JComboBox<>(new String[] {"Fast", "Sorted for each pixel"});
        sorting.setToolTipText("Sorted is right for organs within organs, and takes longer");
        sorting.addActionListener(e -> looks.change(style ->
                style.withTransparency(sorting.getSelectedIndex() == 0 ? Transparency.TWO_PASS : Transparency.PEELED)));
        add(named(sorting, "Quality of translucency"), "wmin 0");
        cut.setEnabled(false);
        listen(session);
    }

    private void listen(Session session) {
        structure.addActionListener(e -> colour());
        field.addActionListener(e -> quantity());
        reference.addActionListener(e -> chooser.get().ifPresent(this::measureFrom));
        least.addActionListener(e -> colour());
        most.addActionListener(e -> colour());
        axis.addActionListener(e -> clip());
        cut.addChangeListener(e -> clip());
        session.listen(new Session.Events() {
            @Override
            public void onScene(LiveScene scene) {
                enter(scene);
            }
        });
    }

    private void heading(String text) {
        JLabel label = new JLabel(text);
        label.putClientProperty("FlatLaf.styleClass", "h4");
        add(label, getComponentCount() == 0 ? "" : "gaptop 8");
    }

    private static <C extends JComponent> C named(C component, String name) {
        component.setName(name);
        component.getAccessibleContext().setAccessibleName(name);
        return component;
    }

    private void overlay(Overlay.Kind kind, String label, String tip) {
        JCheckBox box = new JCheckBox(label);
        box.setToolTipText(tip);
        box.addActionListener(e -> looks.change(style -> style.withOverlay(kind, box.isSelected())));
        add(named(box, label));
    }

    private void enter(LiveScene scene) {
        box = SceneBounds.of(scene.surfaces());
        Object before = structure.getSelectedItem();
        structure.removeAllItems();
        scene.surfaces().stream()
                .filter(surface -> surface.motion() == Surface.Motion.DEFORMING)
                .forEach(surface -> structure.addItem(new Coloured(surface.name(), StructureNames.of(surface))));
        if (before != null) {
            structure.setSelectedItem(before);
        }
    }

    private void quantity() {
        boolean strain = field.getSelectedIndex() == STRAIN;
        least.setText(strain ? "-30" : "0");
        most.setText(strain ? "30" : "20");
        unit.setText(strain ? "%" : "mm");
        boolean distance = field.getSelectedIndex() == DISTANCE;
        reference.setVisible(distance);
        if (distance && looks.reference().isEmpty()) {
            chooser.get().ifPresentOrElse(this::measureFrom, () -> field.setSelectedIndex(0));
        } else {
            colour();
        }
    }

    private void measureFrom(Path file) {
        String before = reference.getText();
        reference.setText("Reading " + file.getFileName());
        new Reading<>(
                        file,
                        () -> new DistanceField(MeshFiles.read(file)),
                        surface -> {
                            reference.setText(file.getFileName() + "...");
                            looks.measureFrom(surface);
                            colour();
                        },
                        sentence -> {
                            reference.setText(before);
                            if (looks.reference().isEmpty()) {
                                field.setSelectedIndex(0);
                            }
                            session.say(Session.Message.Kind.REFUSED, sentence);
                        })
                .execute();
    }

    private void colour() {
        Coloured chosen = (Coloured) structure.getSelectedItem();
        if (chosen == null) {
            return;
        }
        ColourField what =
                switch (field.getSelectedIndex()) {
                    case 1 -> ColourField.DISPLACEMENT;
                    case STRAIN -> ColourField.STRAIN;
                    case DISTANCE -> looks.reference().isPresent() ? ColourField.DISTANCE : ColourField.NONE;
                    default -> ColourField.NONE;
                };
        Optional<ColourScale> scale = scale(what);
        least.putClientProperty("JComponent.outline", scale.isPresent() ? null : "error");
        most.putClientProperty("JComponent.outline", scale.isPresent() ? null : "error");
        scale.ifPresent(colours -> looks.change(style -> style.withField(what, chosen.structure(), colours)));
    }

    private Optional<ColourScale> scale(ColourField what) {
        try {
            double from = Double.parseDouble(least.getText().strip());
            double to = Double.parseDouble(most.getText().strip());
            ColourScale scale =
                    what == ColourField.STRAIN ? ColourScale.signed(1, "%") : ColourScale.magnitude(1, "mm");
            return Optional.of(scale.withRange(from, to));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private void clip() {
        int which = axis.getSelectedIndex();
        cut.setEnabled(which > 0);
        if (which == 0) {
            looks.change(style -> style.withClip(Optional.empty()));
            return;
        }
        // The slider goes from nothing cut away to all of it; from the front it cuts from low y to high.
        double gone = cut.getValue() / (double) WHOLE;
        int along = which - 1;
        double share = which == FROM_FRONT ? gone : 1 - gone;
        double place = box[along] + share * (box[3 + along] - box[along]);
        cut.setToolTipText(String.format(Locale.ROOT, "Where the plane is: %.0f mm", place));
        ClipPlane plane =
                switch (which) {
                    case FROM_FRONT -> ClipPlane.coronal(place);
                    case FROM_ABOVE -> ClipPlane.axial(place);
                    default -> ClipPlane.sagittal(place);
                };
        looks.change(style -> style.withClip(Optional.of(plane)));
    }
}
