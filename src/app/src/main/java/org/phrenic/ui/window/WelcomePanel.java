package org.phrenic.ui.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Font;
import java.awt.Insets;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.Theme;

/**
 * The first panel above the view: a button for each workspace, and the disclaimer. In a narrow view the buttons are one
 * below the other.
 */
final class WelcomePanel extends JPanel {
    private static final int LEFT = 12;
    private static final int RIGHT = 8;
    private static final int NOTICE_GAP = 2;
    private static final int GAP = 8;
    private static final String INSETS = "insets 8 " + LEFT + " 8 " + RIGHT + ", gap " + GAP + " 2, novisualpadding";

    private final JButton rehearse;
    private final JButton tune;
    private final JButton close;
    private final JLabel aboutRehearse = Controls.secondaryLabel("Exercises, needle, report card");
    private final JLabel aboutTune = Controls.secondaryLabel("Parameters, forces, live plots");
    private final JLabel notice = new JLabel(Disclaimer.TEXT);
    private final int wideWidth;
    private int narrowWidth;

    WelcomePanel(Consumer<Workspace> showWorkspace, Runnable dismiss) {
        setName("welcome");
        getAccessibleContext().setAccessibleName("Welcome");
        setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.BORDER));
        notice.setName("notice");
        notice.setFont(notice.getFont().deriveFont(Font.BOLD));
        String tip = "A needle to a target in a liver that moves with the breath, without terms of physics";
        rehearse = button(Workspace.CLINICIAN, tip, showWorkspace);
        tune = button(Workspace.RESEARCHER, "Every parameter, force and plot", showWorkspace);
        close = Controls.iconButton(Icons.CLOSE, "Close this card", dismiss);
        arrange(0);
        wideWidth = getPreferredSize().width;
    }

    /** @param width of a narrow panel, pixels; 0 for a wide one */
    private void arrange(int width) {
        narrowWidth = width;
        boolean narrow = width > 0;
        removeAll();
        if (narrow) {
            setLayout(new MigLayout(INSETS, "[0::, grow, fill][]", ""));
            add(rehearse, "span 2, wmin 0, wrap");
            add(tune, "span 2, wmin 0, wrap");
            add(notice, "gapy 4 0, gapx " + NOTICE_GAP + ", wmin 0");
            add(close, "aligny top");
        } else {
            setLayout(new MigLayout(INSETS, "[0::, sg, fill][0::, sg, fill]push[]", ""));
            add(rehearse, "wmin 0");
            add(tune, "wmin 0");
            add(close, "aligny top, wrap");
            add(aboutRehearse, "gapx 2, wmin 0");
            add(aboutTune, "gapx 2, wmin 0, wrap");
            add(notice, "span 3, gapy 4 0, gapx 2, wmin 0");
        }
        for (JButton door : List.of(rehearse, tune)) {
            door.setMargin(narrow ? new Insets(8, 4, 8, 4) : new Insets(8, 18, 8, 18));
        }
        int room = width - UIScale.scale(LEFT + RIGHT + NOTICE_GAP + GAP) - close.getPreferredSize().width;
        notice.setText(
                narrow ? "<html><body width='" + room + "'>" + Disclaimer.TEXT + "</body></html>" : Disclaimer.TEXT);
        notice.getAccessibleContext().setAccessibleName(Disclaimer.TEXT);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        int now = width < wideWidth ? width : 0;
        if (now != narrowWidth) {
            arrange(now);
            // The height that is asked for is another.
            SwingUtilities.invokeLater(this::revalidate);
        }
    }

    private static JButton button(Workspace workspace, String tip, Consumer<Workspace> showWorkspace) {
        JButton button = Controls.button(workspace.label(), tip, () -> showWorkspace.accept(workspace));
        button.setName("door." + workspace.name());
        button.putClientProperty("FlatLaf.styleClass", "h4");
        return button;
    }
}
