<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>ColorText</name>
    <message numerus="yes">
        <source>%n objects have this color and size: follow all of them, or cover the others.</source>
        <translation>
            <numerusform>%n object has this color and size: follow it, or cover the others.</numerusform>
            <numerusform>%n objects have this color and size: follow all of them, or cover the others.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TakeText</name>
    <message numerus="yes">
        <source>%n dropped image(s)</source>
        <translation>
            <numerusform>%n dropped image</numerusform>
            <numerusform>%n dropped images</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WandSettings</name>
    <message numerus="yes">
        <source>%1 and %2 saw the ball at the same time in only %n frame(s). Move the ball where both cameras see it.</source>
        <translation>
            <numerusform>%1 and %2 saw the ball at the same time in only %n frame. Move the ball where both cameras see it.</numerusform>
            <numerusform>%1 and %2 saw the ball at the same time in only %n frames. Move the ball where both cameras see it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardFloor</name>
    <message numerus="yes">
        <source>The floor is set from the board, which %n camera(s) can see (error %1). The world was rotated by %2.</source>
        <translation>
            <numerusform>The floor is set from the board, which %n camera can see (error %1). The world was rotated by %2.</numerusform>
            <numerusform>The floor is set from the board, which %n cameras can see (error %1). The world was rotated by %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPanel</name>
    <message numerus="yes">
        <source>%n boxes (coordinates in image pixels)</source>
        <translation>
            <numerusform>%n box (coordinates in image pixels)</numerusform>
            <numerusform>%n boxes (coordinates in image pixels)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationChoice</name>
    <message numerus="yes">
        <source>✓ Recognized: %1, %n cameras</source>
        <translation>
            <numerusform>✓ Recognized: %1, %n camera</numerusform>
            <numerusform>✓ Recognized: %1, %n cameras</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraEdits</name>
    <message numerus="yes">
        <source>Add %n camera(s)</source>
        <translation>
            <numerusform>Add %n camera</numerusform>
            <numerusform>Add %n cameras</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraTable</name>
    <message numerus="yes">
        <source>✓ %1×%2 · %3 frames per second · %n frames</source>
        <translation>
            <numerusform>✓ %1×%2 · %3 frames per second · %n frame</numerusform>
            <numerusform>✓ %1×%2 · %3 frames per second · %n frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %n images</source>
        <translation>
            <numerusform>✓ %1×%2 · %n image</numerusform>
            <numerusform>✓ %1×%2 · %n images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The videos differ in length: only the first %n frames are used.</source>
        <translation>
            <numerusform>The videos differ in length: only the first frame (%n) is used.</numerusform>
            <numerusform>The videos differ in length: only the first %n frames are used.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FollowAllButton</name>
    <message numerus="yes">
        <source>Follow all %n objects</source>
        <translation>
            <numerusform>Follow %n object</numerusform>
            <numerusform>Follow all %n objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GapList</name>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MissingFilesOffer</name>
    <message numerus="yes">
        <source>%n files of this project were not found: %1.</source>
        <translation>
            <numerusform>%n file of this project was not found: %1.</numerusform>
            <numerusform>%n files of this project were not found: %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::NoticeList</name>
    <message numerus="yes">
        <source>and %n more notice(s)</source>
        <translation>
            <numerusform>and %n more notice</numerusform>
            <numerusform>and %n more notices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OutputController</name>
    <message numerus="yes">
        <source>Sending, %n program(s) connected</source>
        <translation>
            <numerusform>Sending, %n program connected</numerusform>
            <numerusform>Sending, %n programs connected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointCalibrator</name>
    <message numerus="yes">
        <source>%1: %n point(s) clicked, but at least %2 are needed (six are better)</source>
        <translation>
            <numerusform>%1: %n point clicked, but at least %2 are needed (six are better)</numerusform>
            <numerusform>%1: %n points clicked, but at least %2 are needed (six are better)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectCheckDialog</name>
    <message numerus="yes">
        <source>%n problem(s) must be solved before this project can be tracked.</source>
        <translation>
            <numerusform>%n problem must be solved before this project can be tracked.</numerusform>
            <numerusform>%n problems must be solved before this project can be tracked.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RoomDisplay</name>
    <message numerus="yes">
        <source>%n views captured</source>
        <translation>
            <numerusform>%n view captured</numerusform>
            <numerusform>%n views captured</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunAlerts</name>
    <message numerus="yes">
        <source>◆ %n notice(s)</source>
        <translation>
            <numerusform>◆ %n notice</numerusform>
            <numerusform>◆ %n notices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryPanel</name>
    <message numerus="yes">
        <source>%n rows are on the clipboard as CSV.</source>
        <translation>
            <numerusform>%n row is on the clipboard as CSV.</numerusform>
            <numerusform>%n rows are on the clipboard as CSV.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples, no gaps</source>
        <translation>
            <numerusform>%n sample, no gaps</numerusform>
            <numerusform>%n samples, no gaps</numerusform>
        </translation>
    </message>
</context>
</TS>
