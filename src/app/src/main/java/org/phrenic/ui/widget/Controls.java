package org.phrenic.ui.widget;

import java.awt.Component;
import java.awt.Container;
import java.awt.FocusTraversalPolicy;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.AbstractButton;
import javax.swing.DefaultListCellRenderer;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.ListCellRenderer;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.event.PopupMenuEvent;
import javax.swing.event.PopupMenuListener;
import javax.swing.text.JTextComponent;
import net.miginfocom.swing.MigLayout;

/** Makes controls of one style; each has a tooltip and an accessible name. */
public final class Controls {
    /** Between a control and the tooltip below it, pixels. */
    private static final int TIP_GAP = 2;

    private Controls() {}

    /** Of a window whose focus is at one part first, and whenever the part that had it is no more. */
    public static FocusTraversalPolicy beginningAt(Component first) {
        return new LayoutFocusTraversalPolicy() {
            @Override
            public Component getDefaultComponent(Container window) {
                return first;
            }
        };
    }

    /** Names a control for screen readers and tests, and gives it a tooltip. */
    public static <C extends JComponent> C describe(C control, String name, String tip) {
        control.setName(name);
        control.getAccessibleContext().setAccessibleName(name);
        control.setToolTipText(tip);
        return control;
    }

    /**
     * Tells a screen reader the value that a control shows, such as "300 N/m": its description. Without a value that is
     * its tooltip.
     */
    public static void tellValue(JComponent control, String value) {
        control.getAccessibleContext().setAccessibleDescription(value.isEmpty() ? null : value);
    }

    /** Marks a field whose text cannot be used, and tells a screen reader why; empty if it can be used. */
    public static void mark(JComponent field, Optional<String> problem) {
        field.putClientProperty("JComponent.outline", problem.isPresent() ? "error" : null);
        tellValue(field, problem.orElse(""));
    }

    /** Calls an action after each edit of a text. */
    public static void onEdit(JTextComponent text, Runnable action) {
        text.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                action.run();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                action.run();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                action.run();
            }
        });
    }

    /** Calls an action when the list of a box closes while the box has the focus. */
    public static void onListClosed(JComboBox<?> box, Runnable action) {
        box.addPopupMenuListener(new PopupMenuListener() {
            @Override
            public void popupMenuWillBecomeVisible(PopupMenuEvent e) {}

            @Override
            public void popupMenuWillBecomeInvisible(PopupMenuEvent e) {
                if (box.isFocusOwner()) {
                    action.run();
                }
            }

            @Override
            public void popupMenuCanceled(PopupMenuEvent e) {}
        });
    }

    /** A slider whose tooltip appears below it, so that its knob stays in sight. */
    public static JSlider slider(int minimum, int maximum, int value) {
        return new JSlider(minimum, maximum, value) {
            @Override
            public Point getToolTipLocation(MouseEvent e) {
                return new Point(0, getHeight() + TIP_GAP);
            }
        };
    }

    public static JButton button(String text, String tip, Runnable action) {
        return withAction(describe(new JButton(text), text.replace("...", ""), tip), action);
    }

    /** A panel of components in a MigLayout with these constraints of the layout and of its columns. */
    public static JPanel panel(String layout, String columns, Component... parts) {
        JPanel panel = new JPanel(new MigLayout(layout, columns));
        for (Component part : parts) {
            panel.add(part, "wmin 0");
        }
        return panel;
    }

    /** A renderer of lists that shows the text of each value. */
    public static ListCellRenderer<Object> renderer(Function<Object, String> text) {
        return new DefaultListCellRenderer() {
            @Override
            public Component getListCellRendererComponent(
                    JList<?> list, Object value, int index, boolean selected, boolean focused) {
                return super.getListCellRendererComponent(list, text.apply(value), index, selected, focused);
            }
        };
    }

    /** A flat button with an icon, as in a tool bar. */
    public static JButton iconButton(Icon icon, String name, Runnable action) {
        return withAction(flat(describe(new JButton(icon), name, name)), action);
    }

    /** Makes a button flat, as in a tool bar. */
    public static <B extends AbstractButton> B flat(B button) {
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }

    private static <B extends AbstractButton> B withAction(B button, Runnable action) {
        button.addActionListener(e -> action.run());
        return button;
    }

    /** Gives a pressed button the colours of a selected row of a list. */
    public static JToggleButton highlightWhenSelected(JToggleButton button) {
        button.putClientProperty(
                "FlatLaf.style",
                "selectedBackground: $List.selectionBackground; selectedForeground: $List.selectionForeground");
        return button;
    }

    public static JLabel heading(String text) {
        JLabel label = new JLabel(text);
        label.putClientProperty("FlatLaf.styleClass", "h4");
        return label;
    }

    /** Text in the colour that matters less. */
    public static JLabel secondaryLabel(String text) {
        JLabel label = new JLabel(text);
        label.setForeground(Theme.SECONDARY_TEXT);
        return label;
    }

    /** A copy of a graphics context with smooth lines and letters; to be disposed of. */
    public static Graphics2D smooth(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        return g;
    }

    /** Text with a capital at its beginning. */
    public static String capitalise(String text) {
        return text.isEmpty() ? text : Character.toUpperCase(text.charAt(0)) + text.substring(1);
    }

    /** Text as HTML shows it. */
    public static String escapeHtml(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;");
    }
}
