package org.phrenic.ui.window;

import java.awt.Font;
import java.awt.Insets;
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
    private final JButton rehearse;
    private final JButton tune;
    private final JButton close;
    private final JLabel aboutRehearse = Controls.secondaryLabel("Exercises, needle, report card");
    private final JLabel aboutTune = Controls.secondaryLabel("Parameters, forces, live plots");
    private final JLabel notice = new JLabel(Disclaimer.TEXT);
    private final int wideWidth;
    private boolean narrow;

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
        arrange(false);
        wideWidth = getPreferredSize().width;
    }

    private void arrange(boolean asNarrow) {
        narrow = asNarrow;
        removeAll();
        if (narrow) {
            setLayout(new MigLayout("insets 8 12 8 8, gap 8 2, novisualpadding", "[0::, grow, fill][]", ""));
            add(rehearse, "wmin 0");
            add(close, "aligny top, wrap");
            add(tune, "wmin 0, wrap");
            add(notice, "span 2, gapy 4 0, gapx 2, wmin 0");
        } else {
            setLayout(new MigLayout(
                    "insets 8 12 8 8, gap 8 2, novisualpadding", "[0::, sg, fill][0::, sg, fill]push[]", ""));
            add(rehearse, "wmin 0");
            add(tune, "wmin 0");
            add(close, "aligny top, wrap");
            add(aboutRehearse, "gapx 2, wmin 0");
            add(aboutTune, "gapx 2, wmin 0, wrap");
            add(notice, "span 3, gapy 4 0, gapx 2, wmin 0");
        }
        notice.setText(narrow ? "<html>" + Disclaimer.TEXT.replace(". ", ".<br>") + "</html>" : Disclaimer.TEXT);
        notice.getAccessibleContext().setAccessibleName(Disclaimer.TEXT);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        boolean now = width > 0 && width < wideWidth;
        if (now != narrow) {
            arrange(now);
            // The height that is asked for is another.
            SwingUtilities.invokeLater(this::revalidate);
        }
    }

    private static JButton button(Workspace workspace, String tip, Consumer<Workspace> showWorkspace) {
        JButton button = Controls.button(workspace.label(), tip, () -> showWorkspace.accept(workspace));
        button.setName("door." + workspace.name());
        button.putClientProperty("FlatLaf.styleClass", "h4");
        button.setMargin(new Insets(8, 18, 8, 18));
        return button;
    }
}
