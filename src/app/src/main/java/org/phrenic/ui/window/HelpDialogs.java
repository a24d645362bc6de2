package org.phrenic.ui.window;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Frame;
import java.util.List;
import java.util.Optional;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import net.miginfocom.swing.MigLayout;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Dialogs;

/** Help > Keys and Help > About. */
final class HelpDialogs {
    private static final String CITATION =
            "Villard, P.-F., Bourne, W., Bello, F.: Interactive Simulation of Diaphragm Motion Through Muscle and Rib"
                    + " Kinematics. In: Recent Advances in the 3D Physiological Human. Springer, 2009."
                    + " doi 10.1007/978-1-84882-565-9_6";

    static final String[][] LIBRARIES = {
        {"JOGL, GlueGen", "drawing with OpenGL", "BSD 2-clause"},
        {"FlatLaf", "look and feel of the window", "Apache-2.0"},
        {"MigLayout", "layout of the window", "BSD 3-clause"},
        {"JFreeChart", "plots", "LGPL 2.1 or later"},
        {"EJML", "small dense algebra", "Apache-2.0"},
        {"Apache Commons Math", "splines, statistics, fits", "Apache-2.0"},
        {"Apache Commons CSV, IO, Codec", "tables", "Apache-2.0"},
        {"Apache Commons Compress, Lang", "unpacking of scans and meshes", "Apache-2.0"},
        {"picocli", "command line", "Apache-2.0"},
        {"Jackson, SnakeYAML", "scenarios, JSON", "Apache-2.0"},
        {"JOML", "cameras", "MIT"},
    };

    private HelpDialogs() {}

    /** The table of keys, made from the actions. */
    static JDialog keys(Frame owner, List<MenuAction> actions) {
        String[][] rows = actions.stream()
                .filter(action -> action.accelerator() != null)
                .map(action -> new String[] {action.acceleratorText(), action.name(), action.tip()})
                .toArray(String[][]::new);
        String[][] mouse = {
            {"Left drag", "Turn", "About the patient's long axis and up or down"},
            {"Middle or Shift+drag", "Move", "In the plane of the picture"},
            {"Wheel", "Enlarge", "Towards the cursor; with an entry by Ctrl+wheel"},
            {"Click", "Name", "Structure and place, in the status line"},
            {"Enter", "Click in the middle", "Names what is there, or chooses what T, E, U ask for (rehearsing)"},
            {"Double click", "Turn about here", "The view turns about the place under the cursor"},
            {"Wheel, with an entry", "Insert or withdraw", "2 mm a notch; with Shift 10 mm (rehearsing)"},
            {"Left drag of the hub", "Turn the needle", "About its point on the skin (rehearsing)"},
            {"Left drag of the probe", "Slide the probe", "Over the skin (rehearsing)"},
            {"Right drag of the probe", "Tilt and rock", "Or Ctrl+left drag (rehearsing)"},
        };
        JPanel content = new JPanel(new MigLayout("insets 14, gap 8, wrap 1", "[grow, fill]", "[grow, fill][][fill]"));
        content.add(new JScrollPane(keyTable("Keys", rows)));
        content.add(new JLabel("In the view"));
        JScrollPane below = new JScrollPane(keyTable("Mouse", mouse));
        below.setPreferredSize(new Dimension(640, 220));
        content.add(below);
        return closable(owner, "Keys", content, new Dimension(880, 620));
    }

    private static JTable keyTable(String name, String[][] rows) {
        JTable table = Dialogs.table(name, rows, name, "Does", "That is");
        table.setRowHeight(table.getRowHeight() + 4);
        return Dialogs.fitColumns(table);
    }

    /** Version, citation, licences and the disclaimer. */
    static JDialog about(Frame owner, Optional<String> graphics) {
        String version = HelpDialogs.class.getPackage().getImplementationVersion();
        JLabel title = bold("Phrenic" + (version == null ? "" : " " + version));
        title.setFont(title.getFont().deriveFont(title.getFont().getSize2D() * 1.6f));
        JTable libraries = Dialogs.fitColumns(
                Dialogs.table("Libraries and their licences", LIBRARIES, "Library", "For", "Licence"));
        JScrollPane scroll = new JScrollPane(libraries);
        scroll.setPreferredSize(new Dimension(640, libraries.getRowHeight() * (LIBRARIES.length + 1) + 12));
        JPanel content = new JPanel(new MigLayout("insets 18, gap 8, wrap 1", "[grow, fill]", ""));
        content.add(title);
        content.add(new JLabel("A simulator of breathing: diaphragm, ribs, sternum, lungs and liver."));
        content.add(bold(Disclaimer.TEXT), "gapbottom 8");
        content.add(Dialogs.wrappedText("It implements and extends " + CITATION), "wmin 0");
        content.add(Dialogs.wrappedText("Apache License 2.0. It uses:"), "wmin 0, gapbottom 0");
        content.add(scroll, "gapbottom 8");
        String platform =
                "Java " + Runtime.version() + graphics.map(g -> "; " + g).orElse("");
        content.add(Dialogs.wrappedText(platform), "wmin 0");
        JDialog about = closable(owner, "About Phrenic", content, new Dimension(700, 560));
        // Without a cursor in the first text, that looks as if it could be edited.
        about.setFocusTraversalPolicy(Controls.beginningAt(about.getRootPane().getDefaultButton()));
        return about;
    }

    private static JLabel bold(String text) {
        JLabel label = new JLabel(text);
        label.setFont(label.getFont().deriveFont(Font.BOLD));
        return label;
    }

    private static JDialog closable(Frame owner, String title, JPanel content, Dimension size) {
        return Dialogs.of(owner, title, content, size, "", Dialogs.closing("Close", "Close this dialog", () -> {}));
    }
}
