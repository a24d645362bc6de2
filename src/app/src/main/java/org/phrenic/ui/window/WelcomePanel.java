package org.phrenic.ui.window;

import java.awt.Font;
import java.awt.Insets;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.Theme;

/** The first panel above the view: a button for each workspace, and the disclaimer. */
final class WelcomePanel extends JPanel {
    WelcomePanel(Consumer<Workspace> showWorkspace, Runnable dismiss) {
        super(new MigLayout("insets 8 12 8 8, gap 8 2, novisualpadding", "[0::, sg, fill][0::, sg, fill]push[]", ""));
        setName("welcome");
        getAccessibleContext().setAccessibleName("Welcome");
        setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.BORDER));
        JLabel notice = new JLabel(Disclaimer.TEXT);
        notice.setName("notice");
        notice.setFont(notice.getFont().deriveFont(Font.BOLD));
        String tip = "A needle to a target in a liver that moves with the breath, without terms of physics";
        add(button(Workspace.CLINICIAN, tip, showWorkspace), "wmin 0");
        add(button(Workspace.RESEARCHER, "Every parameter, force and plot", showWorkspace), "wmin 0");
        add(Controls.iconButton(Icons.CLOSE, "Close this card", dismiss), "aligny top, wrap");
        add(Controls.secondaryLabel("Exercises, needle, report card"), "gapx 2, wmin 0");
        add(Controls.secondaryLabel("Parameters, forces, live plots"), "gapx 2, wmin 0, wrap");
        add(notice, "span 3, gapy 4 0, gapx 2, wmin 0");
    }

    private static JButton button(Workspace workspace, String tip, Consumer<Workspace> showWorkspace) {
        JButton button = Controls.button(workspace.label(), tip, () -> showWorkspace.accept(workspace));
        button.setName("door." + workspace.name());
        button.putClientProperty("FlatLaf.styleClass", "h4");
        button.setMargin(new Insets(8, 18, 8, 18));
        return button;
    }
}
