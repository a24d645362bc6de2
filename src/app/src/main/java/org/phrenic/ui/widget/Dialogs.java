package org.phrenic.ui.widget;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.table.DefaultTableModel;
import net.miginfocom.swing.MigLayout;

/** Makes dialogs of one style: content, and below it a note and a row of buttons. */
public final class Dialogs {
    /** Beside the text of a cell, pixels. */
    private static final int CELL_GAP = 8;

    private Dialogs() {}

    /**
     * A dialog that is not shown yet. The Escape key closes it.
     *
     * @param size wanted size; the screen of the owner limits it
     * @param note text above the buttons, or empty
     * @param buttons the last one is the default button
     */
    public static JDialog of(
            Window owner, String title, JComponent content, Dimension size, String note, JButton... buttons) {
        JDialog dialog = new JDialog(owner, title);
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        JPanel foot = new JPanel(new MigLayout("insets 0 14 14 14, fillx", "push" + "[]".repeat(buttons.length)));
        if (!note.isEmpty()) {
            foot.add(Controls.secondaryLabel(note), "span, growx, wmin 0, wrap");
        }
        for (JButton button : buttons) {
            foot.add(button);
            dialog.getRootPane().setDefaultButton(button);
        }
        dialog.getContentPane().add(content);
        dialog.getContentPane().add(foot, BorderLayout.SOUTH);
        KeyStroke escape = KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0);
        dialog.getRootPane().registerKeyboardAction(e -> dialog.dispose(), escape, JComponent.WHEN_IN_FOCUSED_WINDOW);
        dialog.setSize(within(UIScale.scale(size), screen(owner == null ? dialog : owner)));
        dialog.setLocationRelativeTo(owner);
        return dialog;
    }

    private static Dimension within(Dimension wanted, Dimension most) {
        return new Dimension(Math.min(wanted.width, most.width), Math.min(wanted.height, most.height));
    }

    /** What can be used of the screen that shows a window. */
    private static Dimension screen(Window window) {
        GraphicsConfiguration configuration = window.getGraphicsConfiguration();
        Insets taken = window.getToolkit().getScreenInsets(configuration);
        Rectangle all = configuration.getBounds();
        return new Dimension(all.width - taken.left - taken.right, all.height - taken.top - taken.bottom);
    }

    /** A button that closes its dialog, and then runs an action. */
    public static JButton closing(String text, String tip, Runnable then) {
        JButton button = Controls.describe(new JButton(text), text, tip);
        button.addActionListener(e -> {
            SwingUtilities.getWindowAncestor(button).dispose();
            then.run();
        });
        return button;
    }

    /** Asks a question; true for yes. The Enter key says no. */
    public static boolean confirm(Component parent, String title, String question) {
        return ask(parent, title, question, JOptionPane.QUESTION_MESSAGE, "No", "Yes", "No");
    }

    /** Asks whether to do what loses something; true if its button is pressed, beside which Cancel is the default. */
    public static boolean confirmRisk(Component parent, String title, String question, String does) {
        return ask(parent, title, question, JOptionPane.WARNING_MESSAGE, "Cancel", does, "Cancel");
    }

    /** Asks whether to do once more what keeps something; true for its button, which the Enter key presses. */
    public static boolean confirmRetry(Component parent, String title, String question, String gives) {
        return ask(parent, title, question, JOptionPane.WARNING_MESSAGE, "Try again", "Try again", gives);
    }

    /** True for the first answer. */
    private static boolean ask(
            Component parent, String title, String question, int kind, String byEnter, String... answers) {
        int options = JOptionPane.DEFAULT_OPTION;
        return JOptionPane.showOptionDialog(parent, question, title, options, kind, null, answers, byEnter) == 0;
    }

    /** A table of text that cannot be edited. */
    public static JTable table(String name, String[][] rows, String... columns) {
        JTable table =
                new JTable(new DefaultTableModel(rows, columns) {
                    @Override
                    public boolean isCellEditable(int row, int column) {
                        return false;
                    }
                }) {
                    @Override
                    public String getToolTipText(MouseEvent e) {
                        int row = rowAtPoint(e.getPoint());
                        int column = columnAtPoint(e.getPoint());
                        return row < 0 || column < 0
                                ? null
                                : getValueAt(row, column).toString();
                    }
                };
        table.getAccessibleContext().setAccessibleName(name);
        return leftByTab(table);
    }

    /** Lets the Tab key go on to the next part of the window, not to the next cell, which the arrow keys go to. */
    public static JTable leftByTab(JTable table) {
        table.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        table.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        return table;
    }

    /** Text that wraps, and that can be selected. */
    public static JTextArea wrappedText(String text) {
        JTextArea area = new JTextArea(text);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.setEditable(false);
        area.setOpaque(false);
        area.setFont(new JLabel().getFont());
        area.setBorder(BorderFactory.createEmptyBorder());
        return area;
    }

    /**
     * Makes the columns of a table as wide as their widest texts; where there is less room, the tip of a cell tells it.
     */
    public static JTable fitColumns(JTable table) {
        for (int column = 0; column < table.getColumnCount(); column++) {
            int width = 0;
            for (int row = 0; row < table.getRowCount(); row++) {
                Component cell = table.prepareRenderer(table.getCellRenderer(row, column), row, column);
                width = Math.max(width, cell.getPreferredSize().width);
            }
            table.getColumnModel().getColumn(column).setPreferredWidth(width + UIScale.scale(CELL_GAP));
        }
        return table;
    }

    /** Sets the preferred widths of the columns of a table, pixels where letters have their usual size. */
    public static JTable widths(JTable table, int... widths) {
        for (int i = 0; i < widths.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(UIScale.scale(widths[i]));
        }
        return table;
    }
}
