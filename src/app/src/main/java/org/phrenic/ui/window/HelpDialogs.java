package org.phrenic.ui.window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Frame;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.table.DefaultTableModel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.widget.WindowNotice;

/** Help > Keys and Help > About. */
final class HelpDialogs {
    private static final String CITATION =
            "Villard, P.-F., Bourne, W., Bello, F.: Interactive Simulation of Diaphragm Motion Through Muscle and Rib"
                    + " Kinematics. In: Recent Advances in the 3D Physiological Human. Springer, 2009."
                    + " doi 10.1007/978-1-84882-565-9_6";

    private static final String[][] LIBRARIES = {
        {"JOGL, GlueGen", "drawing with OpenGL", "BSD 2-clause"},
        {"FlatLaf", "look of the window", "Apache-2.0"},
        {"MigLayout", "layout of the window", "BSD 3-clause"},
        {"JFreeChart", "plots", "LGPL 2.1 or later"},
        {"EJML", "small dense algebra", "Apache-2.0"},
        {"Apache Commons Math", "splines, statistics, fits", "Apache-2.0"},
        {"Apache Commons CSV, IO, Codec", "tables", "Apache-2.0"},
        {"picocli", "command line", "Apache-2.0"},
        {"SnakeYAML", "scenarios", "Apache-2.0"},
    };

    private HelpDialogs() {}

    /** Escape closes it, as one expects. */
    static void closeOnEscape(JDialog dialog) {
        dialog.getRootPane()
                .registerKeyboardAction(
                        e -> dialog.setVisible(false),
                        KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
                        JComponent.WHEN_IN_FOCUSED_WINDOW);
    }

    /** The table of keys, made from the commands themselves. */
    static JDialog keys(Frame owner, List<MenuAction> commands) {
        Object[][] rows = commands.stream()
                .filter(command -> command.accelerator() != null)
                .map(command -> new Object[] {command.acceleratorText(), command.name(), command.tip()})
                .toArray(Object[][]::new);
        Object[][] mouse = {
            {"Left drag", "Turn", "About the patient's long axis and up or down"},
            {"Middle drag, Shift+left drag", "Move", "In the plane of the picture"},
            {"Wheel", "Enlarge", "Towards the cursor"},
            {"Click", "Name", "Structure and place under the cursor, in the status line"},
            {"Double click", "Turn about here", "The view turns about the place under the cursor"},
        };
        JPanel content = new JPanel(new MigLayout("insets 14, gap 8, wrap 1", "[grow, fill]", "[grow, fill][][fill]"));
        content.add(new JScrollPane(table("Keys", rows)));
        content.add(new JLabel("In the view"));
        JScrollPane below = new JScrollPane(table("Mouse", mouse));
        below.setPreferredSize(new Dimension(640, 150));
        content.add(below);
        return dialog(owner, "Keys", content, new Dimension(720, 620));
    }

    private static JTable table(String name, Object[][] rows) {
        DefaultTableModel model = new DefaultTableModel(rows, new Object[] {name, "Does", "That is"}) {
            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }
        };
        JTable table = new JTable(model);
        table.getAccessibleContext().setAccessibleName(name);
        table.setRowHeight(table.getRowHeight() + 4);
        table.getColumnModel().getColumn(0).setPreferredWidth(150);
        table.getColumnModel().getColumn(1).setPreferredWidth(160);
        table.getColumnModel().getColumn(2).setPreferredWidth(360);
        return table;
    }

    /** Version, citation, licences, and what the program is not for. */
    static JDialog about(Frame owner, Optional<String> graphics) {
        String version = Optional.ofNullable(HelpDialogs.class.getPackage().getImplementationVersion())
                .map(v -> " " + v)
                .orElse("");
        JLabel title = new JLabel("Phrenic" + version);
        title.setFont(title.getFont().deriveFont(Font.BOLD, title.getFont().getSize2D() * 1.6f));
        JLabel notice = new JLabel(WindowNotice.TEXT);
        notice.setFont(notice.getFont().deriveFont(Font.BOLD));
        JPanel content = new JPanel(new MigLayout("insets 18, gap 8, wrap 1", "[grow, fill]", ""));
        content.add(title);
        content.add(new JLabel("A simulator of breathing: diaphragm, ribs, sternum, lungs and liver."));
        content.add(notice, "gapbottom 8");
        content.add(wrappedText("It implements and extends " + CITATION), "wmin 0");
        content.add(wrappedText("Apache License 2.0. It uses:"), "wmin 0, gapbottom 0");
        content.add(libraries(), "gapbottom 8");
        content.add(
                wrappedText("Java " + Runtime.version()
                        + graphics.map(g -> "; " + g).orElse("")),
                "wmin 0");
        return dialog(owner, "About Phrenic", content, new Dimension(620, 560));
    }

    private static Component libraries() {
        DefaultTableModel model = new DefaultTableModel(LIBRARIES, new Object[] {"Library", "For", "Licence"}) {
            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }
        };
        JTable table = new JTable(model);
        table.getAccessibleContext().setAccessibleName("Libraries and their licences");
        JScrollPane pane = new JScrollPane(table);
        pane.setPreferredSize(new Dimension(560, table.getRowHeight() * (LIBRARIES.length + 1) + 12));
        return pane;
    }

    private static JTextArea wrappedText(String words) {
        JTextArea area = new JTextArea(words);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.setEditable(false);
        area.setOpaque(false);
        area.setFont(new JLabel().getFont());
        area.setBorder(BorderFactory.createEmptyBorder());
        return area;
    }

    private static JDialog dialog(Frame owner, String title, JPanel content, Dimension size) {
        JDialog dialog = new JDialog(owner, title);
        JButton close = new JButton("Close");
        close.addActionListener(e -> dialog.dispose());
        JPanel foot = new JPanel(new MigLayout("insets 0 14 14 14, fillx", "push[]", ""));
        foot.add(close);
        dialog.getContentPane().add(content);
        dialog.getContentPane().add(foot, BorderLayout.SOUTH);
        dialog.getRootPane().setDefaultButton(close);
        dialog.setSize(size);
        dialog.setLocationRelativeTo(owner);
        closeOnEscape(dialog);
        return dialog;
    }
}
