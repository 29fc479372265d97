<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>新しいプロジェクト…</translation>
    </message>
    <message>
        <source>Create a project from videos or connected cameras</source>
        <translation>動画や接続されたカメラからプロジェクトを作成します</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>プロジェクトを開く…</translation>
    </message>
    <message>
        <source>Open a project file</source>
        <translation>プロジェクトファイルを開きます</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>デモを開く</translation>
    </message>
    <message>
        <source>Open the simulated demo scene</source>
        <translation>シミュレーションのデモシーンを開く</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the changes to the project file</source>
        <translation>変更をプロジェクトファイルに保存します</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>プロジェクトを別の名前で保存</translation>
    </message>
    <message>
        <source>Close project</source>
        <translation>プロジェクトを閉じる</translation>
    </message>
    <message>
        <source>Go back to the start page</source>
        <translation>開始ページに戻ります</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Quit Dewpoint</source>
        <translation>Dewpoint を終了</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>最後の変更を元に戻します</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>最後に元に戻した変更をやり直します</translation>
    </message>
    <message>
        <source>Shortcuts…</source>
        <translation>ショートカット…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>再生または一時停止</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>次のフレーム</translation>
    </message>
    <message>
        <source>Track one frame and pause</source>
        <translation>1 フレーム追跡して一時停止</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>1 回反復</translation>
    </message>
    <message>
        <source>Run one filter iteration on the current frame and pause</source>
        <translation>現在のフレームでフィルターを 1 回反復して一時停止します</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Start the run again with the same random numbers</source>
        <translation>同じ乱数で、実行を最初からやり直します</translation>
    </message>
    <message>
        <source>Restart with a new seed</source>
        <translation>新しいシードで最初から</translation>
    </message>
    <message>
        <source>Start the run again with other random numbers</source>
        <translation>別の乱数で、実行を最初からやり直します</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Show mask</source>
        <translation>マスクを表示</translation>
    </message>
    <message>
        <source>Show which pixels have the color of a target</source>
        <translation>ターゲットの色をしたピクセルを表示します</translation>
    </message>
    <message>
        <source>Show the room from above in the bird&apos;s-eye view (XY plane)</source>
        <translation>鳥瞰図に部屋を上から見た図を表示します（XY 平面）</translation>
    </message>
    <message>
        <source>Show the room from the front in the bird&apos;s-eye view (XZ plane)</source>
        <translation>鳥瞰図に部屋を正面から見た図を表示します（XZ 平面）</translation>
    </message>
    <message>
        <source>Search actions…</source>
        <translation>操作を検索…</translation>
    </message>
    <message>
        <source>Find any action by its name</source>
        <translation>名前で操作を探します</translation>
    </message>
    <message>
        <source>Restore the default arrangement of the views</source>
        <translation>ビューの配置を既定に戻します</translation>
    </message>
    <message>
        <source>Use the system&apos;s light or dark colors</source>
        <translation>システムの配色（ライトまたはダーク）を使います</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Light colors</source>
        <translation>明るい配色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Dark colors</source>
        <translation>暗い配色</translation>
    </message>
    <message>
        <source>Remove the target</source>
        <translation>ターゲットを取り除く</translation>
    </message>
    <message>
        <source>Remove the selected target from the project</source>
        <translation>選択中のターゲットをプロジェクトから取り除きます</translation>
    </message>
    <message>
        <source>Learn the color</source>
        <translation>色を学習</translation>
    </message>
    <message>
        <source>Click the target in a camera image to learn its color</source>
        <translation>カメラ画像のターゲットをクリックして、その色を学習します</translation>
    </message>
    <message>
        <source>Add a target</source>
        <translation>ターゲットを追加</translation>
    </message>
    <message>
        <source>Track one more object: click it in a camera image</source>
        <translation>物体をもう1つ追跡します。カメラ画像でクリックしてください</translation>
    </message>
    <message>
        <source>Export trajectory…</source>
        <translation>軌跡を書き出す…</translation>
    </message>
    <message>
        <source>Export the trajectory so far for use in another program</source>
        <translation>これまでの軌跡を他のプログラム用に書き出します</translation>
    </message>
    <message>
        <source>Save a picture of a view…</source>
        <translation>ビューの画像を保存…</translation>
    </message>
    <message>
        <source>Save a camera image, the bird&apos;s-eye view or a plot as PNG</source>
        <translation>カメラ画像、鳥瞰図、グラフを PNG で保存します</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>前のフレーム</translation>
    </message>
    <message>
        <source>Step back one frame and show its tracking result</source>
        <translation>前のフレームを追跡時の状態で表示します</translation>
    </message>
    <message>
        <source>Go to latest frame</source>
        <translation>最新のフレームへ</translation>
    </message>
    <message>
        <source>Stop looking back and show the latest tracked frame</source>
        <translation>過去の表示をやめ、最後に追跡したフレームを表示します</translation>
    </message>
    <message>
        <source>Track again from here</source>
        <translation>ここから再追跡</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>マークを追加</translation>
    </message>
    <message>
        <source>Add a named marker at the frame shown</source>
        <translation>表示中のフレームに名前付きのマークを付けます</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>マークを外す</translation>
    </message>
    <message>
        <source>Remove the marker at the frame shown</source>
        <translation>表示中のフレームのマークを外します</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>前のマーク</translation>
    </message>
    <message>
        <source>Go to the previous marker</source>
        <translation>前のマークへ移動します</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>次のマーク</translation>
    </message>
    <message>
        <source>Go to the next marker</source>
        <translation>次のマークへ移動します</translation>
    </message>
    <message>
        <source>Zoom to the selected time span</source>
        <translation>選択した時間の区間を拡大</translation>
    </message>
    <message>
        <source>Show likelihood map</source>
        <translation>尤度マップを表示</translation>
    </message>
    <message>
        <source>Show best particle</source>
        <translation>最良の粒子を表示</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Plot spread</source>
        <translation>広がりを表示</translation>
    </message>
    <message>
        <source>Standard deviation of the particles along x, y and z</source>
        <translation>x、y、z 方向の粒子の標準偏差</translation>
    </message>
    <message>
        <source>Plot effective sample size</source>
        <translation>有効サンプルサイズを表示</translation>
    </message>
    <message>
        <source>Effective sample size, and number of particles</source>
        <translation>有効サンプルサイズと粒子の数</translation>
    </message>
    <message>
        <source>Plot likelihood</source>
        <translation>尤度を表示</translation>
    </message>
    <message>
        <source>How well the estimate fits each camera&apos;s image</source>
        <translation>推定が各カメラの画像にどれだけ合うか</translation>
    </message>
    <message>
        <source>Plot existence</source>
        <translation>存在確率を表示</translation>
    </message>
    <message>
        <source>Existence probability: from all cameras together, and from each camera alone</source>
        <translation>存在確率（全カメラおよび各カメラ単独）</translation>
    </message>
    <message>
        <source>Plot error</source>
        <translation>誤差を表示</translation>
    </message>
    <message>
        <source>Distance between estimate and ground truth, if the truth is known</source>
        <translation>真値がわかる場合の、推定と真値の距離</translation>
    </message>
    <message>
        <source>Plot time per step</source>
        <translation>1 ステップの時間を表示</translation>
    </message>
    <message>
        <source>Plot over time</source>
        <translation>時間軸で表示</translation>
    </message>
    <message>
        <source>Plot against time in seconds instead of filter iterations</source>
        <translation>フィルター反復ではなく時間（秒）に対して表示します</translation>
    </message>
    <message>
        <source>Show whole run</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>Show the whole run in the plots again (or double-click)</source>
        <translation>グラフに実行全体を再び表示します（ダブルクリックでも可）</translation>
    </message>
    <message>
        <source>Copy plots as CSV</source>
        <translation>グラフを CSV でコピー</translation>
    </message>
    <message>
        <source>Copy the numbers of all plots shown, as a table</source>
        <translation>表示中のグラフの数値を表としてコピー</translation>
    </message>
    <message>
        <source>Save plots as picture…</source>
        <translation>グラフを画像として保存…</translation>
    </message>
    <message>
        <source>Copy trajectory as CSV</source>
        <translation>軌跡を CSV でコピー</translation>
    </message>
    <message>
        <source>Copy the selected rows of the trajectory, or all rows if none is selected</source>
        <translation>軌跡の選択行（なければ全行）をコピー</translation>
    </message>
    <message>
        <source>Calibrate by hand…</source>
        <translation>手動でキャリブレーション…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>キャリブレーションをインポート…</translation>
    </message>
    <message>
        <source>Export calibration…</source>
        <translation>キャリブレーションをエクスポート…</translation>
    </message>
    <message>
        <source>Refine the calibration by waving a ball, or a wand with two balls</source>
        <translation>ボール、または2つのボールの付いたワンドを振ってキャリブレーションを精密化します</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>キャリブレーション</translation>
    </message>
    <message>
        <source>Calibrate with a board…</source>
        <translation>ボードでキャリブレーション…</translation>
    </message>
    <message>
        <source>Find the intrinsics and positions of the cameras with a printed board</source>
        <translation>印刷したボードでカメラの内部パラメータと位置を求めます</translation>
    </message>
    <message>
        <source>Print a calibration board…</source>
        <translation>キャリブレーションボードを印刷…</translation>
    </message>
    <message>
        <source>Save the calibration board as a PDF at its true size</source>
        <translation>キャリブレーション用ボードを実寸の PDF に保存します</translation>
    </message>
    <message>
        <source>Plan the rig…</source>
        <translation>配置を計画…</translation>
    </message>
    <message>
        <source>See how accurately the cameras will measure, and where another camera would help</source>
        <translation>カメラの測定精度と、もう1台が役立つ場所を調べます</translation>
    </message>
    <message>
        <source>Show error map</source>
        <translation>誤差マップを表示</translation>
    </message>
    <message>
        <source>Add planned camera</source>
        <translation>計画用のカメラを追加</translation>
    </message>
    <message>
        <source>Add a planned camera; you can then drag it in the bird&apos;s-eye view to try out where to place it</source>
        <translation>計画中のカメラを追加します。鳥瞰図でドラッグして、置く場所を試せます</translation>
    </message>
    <message>
        <source>Recompute the pose of the camera that was moved during the run; all other cameras stay unchanged</source>
        <translation>実行中に動いたカメラの姿勢を計算し直します。他のカメラはそのままです</translation>
    </message>
    <message>
        <source>Find best camera position</source>
        <translation>最適なカメラ位置を探す</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the position where another camera would help most</source>
        <translation>もう1台のカメラが最も役立つ位置を壁と天井で探します</translation>
    </message>
    <message>
        <source>Experiments…</source>
        <translation>実験…</translation>
    </message>
    <message>
        <source>Set box</source>
        <translation>枠を設定</translation>
    </message>
    <message>
        <source>Export 3D shapes of people…</source>
        <translation>人物の3D形状を書き出す…</translation>
    </message>
    <message>
        <source>Save tables of each person&apos;s position, volume, hull and density on the floor</source>
        <translation>各人物の位置、体積、凸包、床の上の密度を表に保存します</translation>
    </message>
    <message>
        <source>Add person…</source>
        <translation>人物を追加…</translation>
    </message>
    <message>
        <source>Click the person in a camera image, or the floor in the bird&apos;s-eye view</source>
        <translation>カメラ画像の中の人物、または鳥瞰図の床をクリックします</translation>
    </message>
    <message>
        <source>Remove person</source>
        <translation>人物を取り除く</translation>
    </message>
    <message>
        <source>Remove the person selected in the table</source>
        <translation>表で選んだ人物を取り除きます</translation>
    </message>
    <message>
        <source>Show 3D shapes of people</source>
        <translation>人物の3D形状を表示</translation>
    </message>
    <message>
        <source>Filter threads…</source>
        <translation>フィルターのスレッド数…</translation>
    </message>
    <message>
        <source>Choose how many processor threads compute the filter</source>
        <translation>フィルターの計算に使うプロセッサのスレッド数を選びます</translation>
    </message>
    <message>
        <source>Correct position</source>
        <translation>位置を修正</translation>
    </message>
    <message>
        <source>Drag a target in the camera images to its true position in this frame; tracking continues from there</source>
        <translation>このフレームで、カメラ画像のターゲットを実際の位置へドラッグします。そこから追跡を続けます</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>修正を取り消す</translation>
    </message>
    <message>
        <source>Remove the correction of the selected target in this frame, or of all targets if none is selected</source>
        <translation>このフレームで選択中のターゲットの修正を取り消します。選択がなければすべてのターゲットが対象です</translation>
    </message>
    <message>
        <source>Show the volume of interest</source>
        <translation>探索範囲を表示</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>再追跡</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>遅く</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>速く</translation>
    </message>
    <message>
        <source>Normal speed</source>
        <translation>通常の速度</translation>
    </message>
    <message>
        <source>Play the recording as fast as it was filmed</source>
        <translation>録画を撮影時と同じ速さで再生します</translation>
    </message>
    <message>
        <source>Play slowly until converged</source>
        <translation>収束するまでゆっくり再生</translation>
    </message>
    <message>
        <source>Show magnifier</source>
        <translation>拡大鏡を表示</translation>
    </message>
    <message>
        <source>Show lines of sight</source>
        <translation>視線を表示</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>拡大</translation>
    </message>
    <message>
        <source>Zoom in on the camera image under the pointer, or on the image of the selected camera (or use the mouse wheel)</source>
        <translation>ポインターの下のカメラ画像、または選択中のカメラの画像を拡大します（マウスホイールでも可）</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Zoom out of the camera image under the pointer, or of the image of the selected camera</source>
        <translation>ポインターの下のカメラ画像、または選択中のカメラの画像を縮小します</translation>
    </message>
    <message>
        <source>Fit image</source>
        <translation>画像全体を表示</translation>
    </message>
    <message>
        <source>Show the whole camera image (or double-click)</source>
        <translation>カメラ画像の全体を表示します（ダブルクリックでも可）</translation>
    </message>
    <message>
        <source>Top view</source>
        <translation>上面図</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>正面図</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D 表示</translation>
    </message>
    <message>
        <source>Fit everything in view</source>
        <translation>すべてをビューに収める</translation>
    </message>
    <message>
        <source>Show the whole room in the bird&apos;s-eye view (or double-click)</source>
        <translation>鳥瞰図に部屋全体を表示します（ダブルクリックでも可）</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>レイアウトをリセット</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全画面表示</translation>
    </message>
    <message>
        <source>Switch between full screen and a normal window</source>
        <translation>全画面と通常のウィンドウを切り替えます</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>Plot position</source>
        <translation>位置を表示</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>マニュアル</translation>
    </message>
    <message>
        <source>Open the manual at the page about the active view</source>
        <translation>アクティブなビューについてのページでマニュアルを開きます</translation>
    </message>
    <message>
        <source>Quick start</source>
        <translation>クイックスタート</translation>
    </message>
    <message>
        <source>What you see in the window, and how to begin in five steps</source>
        <translation>ウィンドウに見えるものと、5 つの手順での始め方</translation>
    </message>
    <message>
        <source>Legend of the overlays</source>
        <translation>重ね描きの凡例</translation>
    </message>
    <message>
        <source>What crosses, ellipses and dots in the images mean</source>
        <translation>画像の中の十字、楕円、点の意味</translation>
    </message>
    <message>
        <source>About the methods</source>
        <translation>手法について</translation>
    </message>
    <message>
        <source>Open the reference of the tracking methods</source>
        <translation>追跡手法のリファレンスを開きます</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>問題を報告…</translation>
    </message>
    <message>
        <source>Collect the information that a bug report needs, ready to copy</source>
        <translation>不具合の報告に必要な情報を集め、コピーできるようにします</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Dewpoint について</translation>
    </message>
    <message>
        <source>Version, license, and how to cite Dewpoint</source>
        <translation>バージョン、ライセンス、Dewpoint の引用方法</translation>
    </message>
    <message>
        <source>Show images in the bird&apos;s-eye view</source>
        <translation>鳥瞰図に画像を表示</translation>
    </message>
    <message>
        <source>Show each camera&apos;s image inside its viewing pyramid in the bird&apos;s-eye view</source>
        <translation>鳥瞰図で、各カメラの画像をその視野の角錐の中に表示します</translation>
    </message>
    <message>
        <source>Set floor and origin…</source>
        <translation>床と原点を設定…</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>キャリブレーション…</translation>
    </message>
    <message>
        <source>See what is known about the cameras, and calibrate them step by step in the way that you choose</source>
        <translation>カメラについて分かっていることを確認し、選んだ方法でステップごとにキャリブレーションします</translation>
    </message>
    <message>
        <source>Play the first iterations of a run one by one, until every target is being tracked (five seconds at most)</source>
        <translation>すべてのターゲットが追跡中になるまで、実行の最初の反復を 1 回ずつ再生します（最長 5 秒）</translation>
    </message>
    <message>
        <source>See and change all keyboard shortcuts</source>
        <translation>すべてのキーボードショートカットを見て変更します</translation>
    </message>
    <message>
        <source>Adjust the calibration of the cameras until a grid drawn over their images matches the real scene</source>
        <translation>画像に重ねて描いた格子が実際の場面に合うまで、カメラのキャリブレーションを調整します</translation>
    </message>
    <message>
        <source>Set the floor, the origin, the axes and the scale of the room with points that you mark in the images</source>
        <translation>画像でマークした点から、部屋の床、原点、軸、縮尺を設定します</translation>
    </message>
    <message>
        <source>Load the calibration of the cameras from a file that another program wrote</source>
        <translation>別のプログラムが書いたファイルからカメラのキャリブレーションを読み込みます</translation>
    </message>
    <message>
        <source>Save the calibration of the cameras for another program</source>
        <translation>カメラのキャリブレーションを別のプログラム用に保存します</translation>
    </message>
    <message>
        <source>In the bird&apos;s-eye view, show the position error to expect for a target at each point</source>
        <translation>ターゲットが各点にあるときに予想される位置誤差を、鳥瞰図に表示します</translation>
    </message>
    <message>
        <source>Track again from the frame shown, with the current method, parameters and colors. To stop, press Pause</source>
        <translation>表示中のフレームから、現在の手法・パラメータ・色で追跡し直します。止めるには一時停止を押します</translation>
    </message>
    <message>
        <source>Track again every frame that was last tracked with earlier settings</source>
        <translation>最後に以前の設定で追跡したフレームをすべて追跡し直します</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to 1/30 of the normal speed</source>
        <translation>録画をより遅く再生します（通常の 1/30 の速さまで）</translation>
    </message>
    <message>
        <source>Play the recording faster, up to eight times the normal speed</source>
        <translation>録画をより速く再生します（通常の 8 倍の速さまで）</translation>
    </message>
    <message>
        <source>Fill the timeline with the selected span of the recording</source>
        <translation>選択した録画の区間をタイムライン全体に広げて表示します</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>録画</translation>
    </message>
    <message>
        <source>Record the live cameras into a folder that opens as a project, or stop recording</source>
        <translation>ライブカメラをプロジェクトとして開けるフォルダーに録画する、または録画を停止する</translation>
    </message>
    <message>
        <source>Send results</source>
        <translation>結果を送信</translation>
    </message>
    <message>
        <source>Start or stop sending positions to other programs during the run. Until you start sending, nothing is sent</source>
        <translation>実行中に他のプログラムへの位置の送信を開始または停止します。送信を開始するまで何も送信されません</translation>
    </message>
    <message>
        <source>Outputs…</source>
        <translation>出力…</translation>
    </message>
    <message>
        <source>Choose where results are sent: TCP, WebSocket, OSC, TUIO, CSV</source>
        <translation>結果の送信先を選びます: TCP、WebSocket、OSC、TUIO、CSV</translation>
    </message>
    <message>
        <source>Reproduce figures from the papers that describe the methods, and write a report</source>
        <translation>手法を説明した論文の図を再現し、レポートを書き出します</translation>
    </message>
    <message>
        <source>Show how likely each position around the target is. Circles mark positions at which the method suspects the target</source>
        <translation>ターゲット周辺の各位置の尤度を表示します。円は、手法がターゲットの候補とする位置を示します</translation>
    </message>
    <message>
        <source>In all views, draw a triangle at the particle of each target that has the highest weight</source>
        <translation>すべてのビューで、各ターゲットの重みが最大の粒子に三角形を描きます</translation>
    </message>
    <message>
        <source>When a target&apos;s particles are too close together to tell apart, show them enlarged</source>
        <translation>ターゲットの粒子が密集して見分けられないとき、拡大して表示します</translation>
    </message>
    <message>
        <source>In the bird&apos;s-eye view, draw a line from each camera to the target. The line is dashed if the camera cannot see the target</source>
        <translation>鳥瞰図に各カメラからターゲットまでの線を引きます。カメラからターゲットが見えない場合、線は破線になります</translation>
    </message>
    <message>
        <source>Draw the volume of interest in the images and in the bird&apos;s-eye view: targets are searched for only inside this box</source>
        <translation>探索範囲をカメラ画像と鳥瞰図に描きます。ターゲットはこの箱の中だけで探します</translation>
    </message>
    <message>
        <source>Show the hull that encloses 95 % of each person&apos;s volume, and lines on the floor around the areas that contain 25, 50, 75 and 95 % of each person</source>
        <translation>各人物の体積の 95 % を囲む凸包と、各人物の 25、50、75、95 % を含む領域を囲む床の上の線を表示</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view in perspective; drag to rotate it</source>
        <translation>透視図の鳥瞰図。ドラッグで回転します</translation>
    </message>
    <message>
        <source>Position along x, y and z, with a band of plus and minus two standard deviations, and the true position if it is known</source>
        <translation>x、y、z 方向の位置と標準偏差の ±2 倍の帯、わかる場合は真の位置</translation>
    </message>
    <message>
        <source>Time that one filter iteration takes for one target, in microseconds</source>
        <translation>1 つのターゲットについてフィルターの 1 反復にかかる時間（マイクロ秒）</translation>
    </message>
    <message>
        <source>Save a picture of the plots as they look now, as SVG or PNG</source>
        <translation>今の表示のままのグラフを SVG または PNG で保存</translation>
    </message>
    <message>
        <source>Check project…</source>
        <translation>プロジェクトをチェック…</translation>
    </message>
    <message>
        <source>Check the recordings, times, calibration, colors and method of the project for problems</source>
        <translation>プロジェクトの録画、時刻、キャリブレーション、色、手法に問題がないか調べます</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>カメラ…</translation>
    </message>
    <message>
        <source>Add, remove, replace and adjust the cameras of the project</source>
        <translation>プロジェクトのカメラを追加、削除、交換、調整します</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>色を固定</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of all connected cameras, and keep the current values</source>
        <translation>接続されたすべてのカメラの自動露出、自動ゲイン、自動ホワイトバランスをオフにし、現在の値を保ちます</translation>
    </message>
    <message>
        <source>Export video…</source>
        <translation>動画を書き出す…</translation>
    </message>
    <message>
        <source>Save the camera views and the bird&apos;s-eye view as a video</source>
        <translation>カメラの表示と鳥瞰図を動画として保存します</translation>
    </message>
    <message>
        <source>Set take number and notes…</source>
        <translation>テイクの番号とメモ…</translation>
    </message>
    <message>
        <source>Set the number and notes of the next take, or the notes of the current take</source>
        <translation>次のテイクの番号とメモ、または録画中のテイクのメモを設定します</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Read the messages of this window again, with their times, and copy them</source>
        <translation>このウィンドウのメッセージを時刻とともにもう一度読み、コピーします</translation>
    </message>
    <message>
        <source>Go to frame…</source>
        <translation>フレームへ移動…</translation>
    </message>
    <message>
        <source>Enter a frame number, or a time such as 2.5 s, and go there</source>
        <translation>フレーム番号、または 2.5 s のような時刻を入力して、そこへ移動します</translation>
    </message>
    <message>
        <source>Previous trouble</source>
        <translation>前のトラブル</translation>
    </message>
    <message>
        <source>Go back to the frame where tracking of the selected target was lost or became uncertain, or where a camera had a problem. If no target is selected, all targets count</source>
        <translation>選択したターゲットの追跡が失われたか不確かになったフレーム、またはカメラに問題が起きたフレームへ戻ります。ターゲットを選択していない場合は、すべてのターゲットが対象です</translation>
    </message>
    <message>
        <source>Next trouble</source>
        <translation>次のトラブル</translation>
    </message>
    <message>
        <source>Go to the next frame where tracking of the selected target is lost or becomes uncertain, or where a camera has a problem. If no target is selected, all targets count</source>
        <translation>選択したターゲットの追跡が失われるか不確かになる次のフレーム、またはカメラに問題が起きる次のフレームへ移動します。ターゲットを選択していない場合は、すべてのターゲットが対象です</translation>
    </message>
    <message>
        <source>Side view</source>
        <translation>側面図</translation>
    </message>
    <message>
        <source>Show the room from the side in the bird&apos;s-eye view (YZ plane)</source>
        <translation>鳥瞰図に部屋を側面から見た図を表示します（YZ 平面）</translation>
    </message>
    <message>
        <source>Hide or show the target</source>
        <translation>ターゲットの表示／非表示</translation>
    </message>
    <message>
        <source>Hide the selected target in the images and in the bird&apos;s-eye view, or show it again. A hidden target is still tracked</source>
        <translation>選択中のターゲットを画像と鳥瞰図で隠す、または再び表示します。隠したターゲットも追跡は続きます</translation>
    </message>
    <message>
        <source>Calibrate with a wand…</source>
        <translation>ワンドでキャリブレーション…</translation>
    </message>
    <message>
        <source>Recompute pose of moved camera</source>
        <translation>動いたカメラの姿勢を再計算</translation>
    </message>
</context>
<context>
    <name>AssessedRegions</name>
    <message>
        <source>also has the target&apos;s color</source>
        <translation>ここもターゲットの色</translation>
    </message>
    <message>
        <source>recognized as the target (if this is wrong, Ctrl+Shift-click here)</source>
        <translation>ターゲットと認識（違う場合はここを Ctrl+Shift+クリック）</translation>
    </message>
    <message>
        <source>some pixels also have the target&apos;s color</source>
        <translation>一部のピクセルもターゲットの色</translation>
    </message>
</context>
<context>
    <name>BoardText</name>
    <message>
        <source>The board&apos;s corners cover only %1 % of the image: show the board in every part of the image, and tilt it too.</source>
        <translation>ボードの角が覆うのは画像の %1 % だけです。画像のあらゆる場所で、傾けても見せてください。</translation>
    </message>
    <message>
        <source>%1 keeps its position because it never saw the board.</source>
        <translation>%1 はボードを一度も見なかったため、位置はそのままです。</translation>
    </message>
    <message>
        <source>Intrinsics</source>
        <translation>内部パラメータ</translation>
    </message>
    <message>
        <source>The intrinsics of %1 are unchanged: %2</source>
        <translation>%1 の内部パラメータはそのままです: %2</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>center</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>left side closer to the camera</source>
        <translation>左側をカメラの近くに</translation>
    </message>
    <message>
        <source>right side closer to the camera</source>
        <translation>右側をカメラの近くに</translation>
    </message>
    <message>
        <source>upper side closer to the camera</source>
        <translation>上側をカメラの近くに</translation>
    </message>
    <message>
        <source>lower side closer to the camera</source>
        <translation>下側をカメラの近くに</translation>
    </message>
    <message>
        <source>facing the camera</source>
        <translation>カメラの正面に</translation>
    </message>
    <message>
        <source>No image yet</source>
        <translation>まだ画像がありません</translation>
    </message>
    <message>
        <source>Show the whole board</source>
        <translation>ボード全体を見せてください</translation>
    </message>
    <message>
        <source>Move the board to: %1</source>
        <translation>ボードを動かす: %1</translation>
    </message>
    <message>
        <source>Turn the board: %1</source>
        <translation>ボードの向き: %1</translation>
    </message>
    <message>
        <source>Move the board closer</source>
        <translation>ボードを近づけてください</translation>
    </message>
    <message>
        <source>Hold the board still</source>
        <translation>ボードを静止させてください</translation>
    </message>
    <message>
        <source>The image is blurred: focus the lens or add light</source>
        <translation>画像がぼけています。ピントを合わせるか明るくしてください</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ 完了</translation>
    </message>
    <message>
        <source>✓ The cameras share enough views of the board</source>
        <translation>✓ 複数のカメラに共通するボードのビューが十分に集まりました</translation>
    </message>
    <message>
        <source>Show the board to %1 and %2 at the same time, hold it still, then repeat elsewhere</source>
        <translation>ボードを%1と%2に同時に見せて静止させ、別の場所でも繰り返してください</translation>
    </message>
    <message>
        <source>board not visible</source>
        <translation>ボードが見えません</translation>
    </message>
    <message>
        <source>⚠ blurred: edges are %1 wide</source>
        <translation>⚠ ぼけ: エッジの幅は %1</translation>
    </message>
    <message>
        <source>sharp: edges are %1 wide</source>
        <translation>鮮明: エッジの幅は %1</translation>
    </message>
    <message>
        <source>%1 views, accuracy %2 (goal: %3)</source>
        <translation>%1 ビュー、精度 %2（目標: %3）</translation>
    </message>
    <message>
        <source>● board visible</source>
        <translation>● ボードが見えています</translation>
    </message>
    <message>
        <source>○ board not visible</source>
        <translation>○ ボードが見えません</translation>
    </message>
    <message>
        <source>%1 views, position accuracy %2</source>
        <translation>%1 ビュー、位置の精度 %2</translation>
    </message>
    <message>
        <source>%1 views shared with other cameras</source>
        <translation>他のカメラと共通のビュー %1</translation>
    </message>
    <message>
        <source>The camera positions could not be computed: %1</source>
        <translation>カメラの位置を計算できませんでした: %1</translation>
    </message>
    <message>
        <source>The accuracy cannot be estimated, because two cameras rarely saw the board at the same time.</source>
        <translation>2 台のカメラが同時にボードを見た回数が少なすぎるため、精度を見積もれません。</translation>
    </message>
    <message>
        <source>a chessboard with %1 × %2 inner corners</source>
        <translation>内側の角が%1 × %2のチェスボード</translation>
    </message>
    <message>
        <source>a ChArUco board with %1 × %2 squares, %3</source>
        <translation>マス目が%1 × %2のChArUcoボード、%3</translation>
    </message>
    <message>
        <source>legacy layout</source>
        <translation>旧レイアウト</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2, focal length %3, accuracy of the intrinsics %5, from %4 images</source>
        <translation>%1: 再投影誤差（RMS）%2、焦点距離 %3、内部パラメータの精度 %5、画像 %4 枚</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2, position ±%3, direction ±%4</source>
        <translation>%1: 再投影誤差（RMS）%2、位置 ±%3、向き ±%4</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2</source>
        <translation>%1: 再投影誤差（RMS）%2</translation>
    </message>
    <message>
        <source>Camera positions: RMS reprojection error %1, from %2 board poses</source>
        <translation>カメラ位置: 再投影誤差（RMS）%1、ボードの姿勢 %2 個</translation>
    </message>
    <message>
        <source>%1 views; at least %2 are needed</source>
        <translation>%1 ビュー（少なくとも %2 必要）</translation>
    </message>
    <message>
        <source>inverted colors</source>
        <translation>白黒反転</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show %3, but mirrored. To correct this, change “Mirrored” in the panel Cameras for the cameras that took these images. Use this board?</source>
        <translation>調べた %2 枚の画像のうち %1 枚に、%3 が左右反転して写っています。直すには、これらの画像を撮影したカメラについて「カメラ」パネルの「鏡像」を変更してください。このボードを使いますか？</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show %3. Use this board?</source>
        <translation>調べた%2枚の画像のうち%1枚に、%3が写っています。このボードを使いますか？</translation>
    </message>
    <message>
        <source>%1 (too few corners: %2)</source>
        <translation>%1(コーナーが少なすぎます:%2)</translation>
    </message>
    <message>
        <source>%1 (blurred: edges are %2 wide)</source>
        <translation>%1(ぼやけています。エッジの幅%2)</translation>
    </message>
    <message>
        <source>%1 (too small: squares are only %2 wide)</source>
        <translation>%1(小さすぎます。マスの幅は%2だけです)</translation>
    </message>
    <message>
        <source>%1: no board was found in frames %2.</source>
        <translation>%1:フレーム%2でボードが見つかりませんでした。</translation>
    </message>
    <message>
        <source>%1: no board was found in frames %2 and in %3 others.</source>
        <translation>%1:フレーム%2とほかの%3フレームでボードが見つかりませんでした。</translation>
    </message>
    <message>
        <source>The video of %1 is mirrored: it shows the board mirrored, but another camera shows the board the right way round.</source>
        <translation>%1の映像は左右反転しています。この映像ではボードが反転して写っていますが、別のカメラでは正しく写っています。</translation>
    </message>
    <message>
        <source>The board or the video of %1 is mirrored: no camera shows the board the right way round. Check whether writing in the images is readable.</source>
        <translation>ボードまたは%1の映像が左右反転しています。ボードを正しく写しているカメラがありません。画像の中の文字が読めるか確認してください。</translation>
    </message>
</context>
<context>
    <name>CalibrationFiles</name>
    <message>
        <source>Calibrations (%1)</source>
        <translation>キャリブレーション (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>CalibrationText</name>
    <message>
        <source>The images of %1 are %2 times as large as those for which it was calibrated: its intrinsics are for another resolution. Convert the intrinsics, or record at the calibrated size.</source>
        <translation>%1 の画像は、キャリブレーションの対象となった画像の %2 倍の大きさです。内部パラメータは別の解像度のものです。内部パラメータを換算するか、キャリブレーションした大きさで録画してください。</translation>
    </message>
    <message>
        <source>all cameras</source>
        <translation>全カメラ</translation>
    </message>
    <message>
        <source>All cameras seem to see the board from behind, or the floor from below: the measured points are probably mirrored. Check the direction of the axes, and make sure that the printed board is not mirrored.</source>
        <translation>すべてのカメラがボードを裏から、または床を下から見ているようです。測定した点がおそらく鏡像になっています。軸の向きと、ボードが左右反転して印刷されていないことを確かめてください。</translation>
    </message>
    <message>
        <source>Everything fits when %1 and %2 are exchanged: their videos are probably swapped. Exchange the two files.</source>
        <translation>%1 と %2 を入れ替えるとすべて合います。動画が逆になっているようです。2つのファイルを入れ替えてください。</translation>
    </message>
    <message>
        <source>%1 agrees with the other cameras only if its video is shifted in time: the video is probably %2 frames late. Synchronize the videos, or calibrate with a wand and turn on “Find delays”.</source>
        <translation>%1 は動画の時間をずらしたときだけ他のカメラと合います。おそらく %2 フレーム遅れています。動画を同期させるか、ワンドで「遅れを求める」をオンにしてキャリブレーションしてください。</translation>
    </message>
    <message>
        <source>%1 agrees with the other cameras only if its video is shifted in time: the video is probably %2 frames early. Synchronize the videos, or calibrate with a wand and turn on “Find delays”.</source>
        <translation>%1 は動画の時間をずらしたときだけ他のカメラと合います。おそらく %2 フレーム早まっています。動画を同期させるか、ワンドで「遅れを求める」をオンにしてキャリブレーションしてください。</translation>
    </message>
    <message>
        <source>The images of %1 fit one pose before %2 and another pose after that time: the camera was probably moved. Calibrate with the later part of the recording only.</source>
        <translation>%1 の画像は %2 より前と後で別の姿勢に合います。カメラが動かされたようです。録画の後の部分だけでキャリブレーションしてください。</translation>
    </message>
    <message>
        <source>The images of %1 fit only if they are flipped: the video is probably mirrored or upside down. Set the rotation and mirroring of these images.</source>
        <translation>%1 の画像は反転させたときだけ合います。動画が鏡像か上下逆のようです。この画像の回転と鏡像を設定してください。</translation>
    </message>
    <message>
        <source>The images of %1 fit a focal length that is %2 times the one in its calibration: the zoom or crop of the camera was probably changed. Calibrate its intrinsics again.</source>
        <translation>%1 の画像は、キャリブレーションの値の %2 倍の焦点距離に合います。カメラのズームまたは切り出しが変わったようです。内部パラメータをキャリブレーションし直してください。</translation>
    </message>
    <message>
        <source>The length that you entered is %1 times the length that the cameras see: millimeters and meters are probably mixed up.</source>
        <translation>入力した長さはカメラの見る長さの %1 倍です。ミリメートルとメートルを取り違えているようです。</translation>
    </message>
    <message>
        <source>The length that you entered is %1 times the length that the cameras see: you probably entered it in inches (1 inch = 2.54 cm).</source>
        <translation>入力した長さはカメラの見る長さの %1 倍です。インチで入力したようです（1 インチ = 2.54 cm）。</translation>
    </message>
    <message>
        <source>The corners form a board with %1 squares in a row, so the number of squares that you entered is probably wrong. Count the squares and correct the number.</source>
        <translation>角は1列にマス目が %1 個あるボードをなしています。入力したマス目の数が違うようです。マス目を数えて数を直してください。</translation>
    </message>
    <message>
        <source>The size of the squares that you entered is %1 times the size that the cameras see. Measure a row with a ruler: prints are often rescaled.</source>
        <translation>入力したマス目の大きさは、カメラの見る大きさの %1 倍です。定規で1列を測ってください。印刷はよく拡大縮小されます。</translation>
    </message>
    <message>
        <source>The images fit only if they are shifted by %1 along both axes: the calibration probably counts pixel coordinates from the corner of the first pixel, not from its center. Convert the principal points.</source>
        <translation>画像は両軸に %1 ずらしたときだけ合います。おそらくキャリブレーションのピクセル座標は、最初のピクセルの中心ではなく角を原点としています。主点を換算してください。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source>±%1 %</source>
        <translation>±%1 %</translation>
    </message>
    <message>
        <source>not measured yet (use the page Floor)</source>
        <translation>未測定（ページ「床」で測定）</translation>
    </message>
    <message>
        <source>In the calibrated volume: position %1, scale %2, upward direction %3 (95 % of the errors are smaller).</source>
        <translation>キャリブレーションした空間内: 位置 %1、縮尺 %2、上方向 %3（誤差の 95 % はこれより小さい）。</translation>
    </message>
    <message>
        <source>Outside the calibrated volume, up to %1 away: position ±%2 (extrapolated).</source>
        <translation>キャリブレーションした空間の外側（%1 以内）では、位置 ±%2（外挿）。</translation>
    </message>
</context>
<context>
    <name>CameraAgreement</name>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped, or %3 and %4.</source>
        <translation>%1 と %2、または %3 と %4 が入れ替わっているようです。</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped.</source>
        <translation>%1 と %2 が入れ替わっているようです。</translation>
    </message>
    <message>
        <source>%1 or %2 points at least %3 away from its calibrated direction.</source>
        <translation>%1 または %2 の向きが、キャリブレーションの向きから少なくとも %3 ずれています。</translation>
    </message>
    <message>
        <source>%1 points about %2 away from its calibrated direction.</source>
        <translation>%1 の向きが、キャリブレーションの向きから約 %2 ずれています。</translation>
    </message>
    <message>
        <source>%1 and %2 disagree about where the target is. Calibrate them again.</source>
        <translation>%1 と %2 では、ターゲットの位置が一致しません。キャリブレーションをやり直してください。</translation>
    </message>
    <message>
        <source>%1 does not agree with the other cameras. Calibrate it again.</source>
        <translation>%1 が他のカメラと一致しません。キャリブレーションをやり直してください。</translation>
    </message>
    <message>
        <source>The images of %1 are about %2 late.</source>
        <translation>%1 の画像は約 %2 遅れています。</translation>
    </message>
    <message>
        <source>The images of %1 are about %2 early.</source>
        <translation>%1 の画像は約 %2 早くなっています。</translation>
    </message>
    <message>
        <source>The calibration seems to be in %1 instead of meters.</source>
        <translation>キャリブレーションの単位がメートルではなく%1になっているようです。</translation>
    </message>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 と %2 の姿勢が同じです。</translation>
    </message>
    <message>
        <source>Swap %1 and %2</source>
        <translation>%1 と %2 を入れ替える</translation>
    </message>
    <message>
        <source>Set the delay of %1</source>
        <translation>%1 の遅れを設定</translation>
    </message>
    <message>
        <source>Correct direction of %1</source>
        <translation>%1 の向きを修正</translation>
    </message>
    <message>
        <source>Convert to meters</source>
        <translation>メートルに換算</translation>
    </message>
</context>
<context>
    <name>CameraDeviceText</name>
    <message>
        <source>Brightness</source>
        <translation>明るさ</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>コントラスト</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>彩度</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Automatic hue</source>
        <translation>自動色相</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>ガンマ</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>Automatic gain</source>
        <translation>自動ゲイン</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>鋭さ</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>自動露出</translation>
    </message>
    <message>
        <source>Exposure time (× 0.1 ms)</source>
        <translation>露出時間 (× 0.1 ms)</translation>
    </message>
    <message>
        <source>Lower frame rate in low light</source>
        <translation>暗所でフレームレートを下げる</translation>
    </message>
    <message>
        <source>Automatic white balance</source>
        <translation>自動ホワイトバランス</translation>
    </message>
    <message>
        <source>White balance (K)</source>
        <translation>ホワイトバランス (K)</translation>
    </message>
    <message>
        <source>Backlight compensation</source>
        <translation>逆光補正</translation>
    </message>
    <message>
        <source>Power line frequency</source>
        <translation>電源周波数</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>フォーカス</translation>
    </message>
    <message>
        <source>Automatic focus</source>
        <translation>オートフォーカス</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>ズーム</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>パン</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>チルト</translation>
    </message>
    <message>
        <source>connector %1</source>
        <translation>コネクター %1</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>シリアル番号 %1</translation>
    </message>
    <message>
        <source>%1, %2 images per second</source>
        <translation>%1、毎秒 %2 枚</translation>
    </message>
    <message>
        <source>%1 %2, %3 images per second</source>
        <translation>%1 %2、毎秒 %3 枚</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on, manual exposure time</source>
        <translation>オン、露出時間は手動</translation>
    </message>
    <message>
        <source>on, manual aperture</source>
        <translation>オン、絞りは手動</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>露出</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>white balance</source>
        <translation>ホワイトバランス</translation>
    </message>
    <message>
        <source>hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>USB bus %1 cannot carry the images of %2: they need %3 Mbit/s, but the bus has only %4 Mbit/s.</source>
        <translation>USB バス %1 は %2 の画像を転送できません: %3 Mbit/s が必要ですが、%4 Mbit/s しかありません。</translation>
    </message>
</context>
<context>
    <name>CameraMotion</name>
    <message>
        <source>rotated by %1</source>
        <translation>%1 回転</translation>
    </message>
</context>
<context>
    <name>CameraNames</name>
    <message>
        <source>camera %1</source>
        <translation>カメラ %1</translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>This camera delivered no image for this frame.</source>
        <translation>このフレームではカメラから画像が届きませんでした。</translation>
    </message>
    <message>
        <source>No images yet. Press play (Space), or open a project (Ctrl+O).</source>
        <translation>まだ画像がありません。再生する（スペース）か、プロジェクトを開いてください（Ctrl+O）。</translation>
    </message>
</context>
<context>
    <name>ClickRadiusText</name>
    <message>
        <source>The target&apos;s radius seems to be about %1.</source>
        <translation>ターゲットの半径は約 %1 のようです。</translation>
    </message>
    <message>
        <source>The marked spot is part of a larger object of the same color. Only this spot is tracked, as a ball with radius %1.</source>
        <translation>印を付けた場所は、同じ色のより大きな物体の一部です。この場所だけを、半径 %1 の球として追跡します。</translation>
    </message>
    <message>
        <source>The target&apos;s radius seems to be about %1, but %2 was entered. Is %2 the diameter?</source>
        <translation>ターゲットの半径は約 %1 のようですが、%2 と入力されています。%2 は直径ではありませんか？</translation>
    </message>
    <message>
        <source>The target&apos;s radius seems to be about %1, but %2 was entered.</source>
        <translation>ターゲットの半径は約 %1 のようですが、%2 と入力されています。</translation>
    </message>
</context>
<context>
    <name>ColorLearner</name>
    <message>
        <source>target %1</source>
        <translation>ターゲット %1</translation>
    </message>
</context>
<context>
    <name>ColorText</name>
    <message>
        <source>at the top left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>at the top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>at the top right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>at the left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>in the center</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>at the right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>at the bottom left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>at the bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>at the bottom right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>black</source>
        <translation>黒い物</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>灰色の物</translation>
    </message>
    <message>
        <source>white</source>
        <translation>白い物</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>茶色の物</translation>
    </message>
    <message>
        <source>red</source>
        <translation>赤い物</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>オレンジ色の物</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>黄色い物</translation>
    </message>
    <message>
        <source>green</source>
        <translation>緑の物</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>青緑の物</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>青い物</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>紫の物</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>ピンクの物</translation>
    </message>
    <message>
        <source>Much of the target does not have the learned color: Shift-click its light and its dark side.</source>
        <translation>ターゲットの多くの部分が、学習した色ではありません。明るい側と暗い側を Shift クリックしてください。</translation>
    </message>
    <message>
        <source>Cover objects of the same color, or take them out of view.</source>
        <translation>同じ色の物体を覆うか、画面の外に出してください。</translation>
    </message>
    <message>
        <source>The target is nearly black here: more light would help.</source>
        <translation>ターゲットがほぼ黒く写っています。明るくすると良くなります。</translation>
    </message>
    <message>
        <source>The target is nearly white here: a shorter exposure would help.</source>
        <translation>ターゲットがほぼ白く写っています。露光を短くすると良くなります。</translation>
    </message>
    <message>
        <source>The target is nearly gray: a stronger color would help.</source>
        <translation>ターゲットがほぼ灰色です。もっと鮮やかな色が良いでしょう。</translation>
    </message>
    <message>
        <source>%1 % of the pixels have this color. Shift-click the target to see how well its color stands out.</source>
        <translation>ピクセルの %1 % がこの色です。ターゲットを Shift クリックすると、その色がどれだけ見分けやすいか分かります。</translation>
    </message>
    <message>
        <source>This color also covers %1 % of the background.</source>
        <translation>背景の %1 % もこの色です。</translation>
    </message>
    <message>
        <source>One sample hardly matches the learned color: the sample resembles its surroundings or shows another object.</source>
        <translation>学習した色にほとんど合わない見本があります。周囲と似ているか、別の物体を示しています。</translation>
    </message>
    <message>
        <source>Several objects have this color: another color would help.</source>
        <translation>この色の物体がいくつもあります。別の色にするとよいでしょう。</translation>
    </message>
    <message>
        <source>This color covers only %1 % of the target, and %2 % of the background.</source>
        <translation>この色なのはターゲットの %1 % だけで、背景では %2 % です。</translation>
    </message>
    <message numerus="yes">
        <source>%n objects have this color and size: follow all of them, or cover the others.</source>
        <translation>
            <numerusform>この色と大きさの物体が %n 個あります: すべて追跡するか、ほかの物体を覆ってください。</numerusform>
        </translation>
    </message>
    <message>
        <source>The color stands out well (%1 of 100 points).</source>
        <translation>この色はよく見分けられます: 100点中%1点。</translation>
    </message>
    <message>
        <source>The color stands out (%1 of 100 points).</source>
        <translation>この色は見分けられます: 100点中%1点。</translation>
    </message>
    <message>
        <source>The color is hard to tell from the background (%1 of 100 points).</source>
        <translation>この色は背景と見分けにくいです: 100点中%1点。</translation>
    </message>
    <message>
        <source>The color hardly stands out (%1 of 100 points).</source>
        <translation>この色はほとんど見分けられません: 100点中%1点。</translation>
    </message>
    <message>
        <source>The clicked region fills much of the image: click only the target, or drag a box around the target.</source>
        <translation>クリックした領域が画像の大部分を占めています。ターゲットだけをクリックするか、ターゲットを囲む枠をドラッグしてください。</translation>
    </message>
    <message>
        <source>You clicked only a speck: drag a box around the whole target.</source>
        <translation>小さな点だけをクリックしました。ターゲット全体を囲む枠をドラッグしてください。</translation>
    </message>
    <message>
        <source>A color range that covers the whole target would also cover %1 % of the background.</source>
        <translation>ターゲット全体を含む色の範囲は、背景の %1 % も含んでしまいます。</translation>
    </message>
    <message>
        <source>Other objects have this color too: Ctrl+Shift-click them to exclude them.</source>
        <translation>ほかの物もこの色です。Ctrl+Shift+クリックして除外してください。</translation>
    </message>
    <message>
        <source>Almost nothing else in the images has this color.</source>
        <translation>画像の中でほかにこの色のものはほとんどありません。</translation>
    </message>
    <message>
        <source>Only %1 % of the background has this color too, which is little compared with the target.</source>
        <translation>この色は背景の %1 % だけで、ターゲットに比べてわずかです。</translation>
    </message>
    <message>
        <source>Outside the target, the largest region of this color (%1) is in the image of %3, %2.</source>
        <translation>ターゲット以外でこの色の最も大きい領域（%1）は、%3 の画像の%2にあります。</translation>
    </message>
</context>
<context>
    <name>Convergence</name>
    <message>
        <source>Convergence</source>
        <translation>収束</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>広がり</translation>
    </message>
    <message>
        <source>Convergence in frame %1 (%2)</source>
        <comment>number of a frame, unit</comment>
        <translation>フレーム %1 の収束（%2）</translation>
    </message>
    <message>
        <source>Spread of the particles after each iteration on this frame. The filter has converged where the curve levels off.</source>
        <translation>このフレームの各反復の後の粒子のばらつき。曲線が平らになる所で、フィルターは収束しています。</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>cannot be written</source>
        <translation>書き込めません</translation>
    </message>
    <message>
        <source>does not match the other data</source>
        <translation>ほかの内容と合いません</translation>
    </message>
    <message>
        <source>ends earlier than expected</source>
        <translation>予定より早く終わっています</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失敗しました</translation>
    </message>
    <message>
        <source>not a usable value</source>
        <translation>使えない値です</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>要求により中止しました</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>カメラを開けません</translation>
    </message>
    <message>
        <source>the camera stopped delivering images</source>
        <translation>カメラから画像が届かなくなりました</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>ファイルを読み込めません</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>cannot be determined from the observations</source>
        <translation>観測からは決まりません</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>this key is missing</source>
        <translation>このキーがありません</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>不明なキーです</translation>
    </message>
    <message>
        <source>wrong type of value</source>
        <translation>値の型が違います</translation>
    </message>
    <message>
        <source>invalid format</source>
        <translation>形式が正しくありません</translation>
    </message>
    <message>
        <source>the camera repeats images</source>
        <translation>カメラが同じ画像を繰り返し送っています</translation>
    </message>
    <message>
        <source>the camera sends fewer images than it should</source>
        <translation>カメラが送る画像が本来より少なくなっています</translation>
    </message>
    <message>
        <source>the images are black</source>
        <translation>画像が真っ黒です</translation>
    </message>
    <message>
        <source>the images arrive late</source>
        <translation>画像の到着が遅れています</translation>
    </message>
    <message>
        <source>the images do not change</source>
        <translation>画像が変化しません</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>Barrera et al. 2005, figure 3: the particles projected into both cameras while the cloud finds the ball.</source>
        <translation>Barrera ら 2005、図3:雲がボールを見つけるまで、両カメラに投影した粒子。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 4: the particle cloud of figure 3 from above.</source>
        <translation>Barrera ら 2005、図4:図3の粒子の雲を上から見たもの。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 6: the object jumps 2 m at iteration 30.</source>
        <translation>Barrera ら 2005、図6:30回目の反復で物体が2 m移動します。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: with one camera, the cloud moves away from the camera.</source>
        <translation>Barrera ら 2005、III-B節：カメラ1台では、雲がカメラから遠ざかります。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 5: where a single camera finds the color, and why the cloud moves away from the camera.</source>
        <translation>Barrera ら 2005、図5:カメラ1台だけで色が見つかる範囲と、雲がそこから遠ざかる理由。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009, figures 1 and 3: the regions that move in a camera&apos;s images, and the likelihood of a person at each pixel.</source>
        <translation>Mohedano ら 2009、図1と図3：カメラの画像で動く領域と、各ピクセルでの人物の尤度。</translation>
    </message>
    <message>
        <source>Drift of the estimate along the optical axis</source>
        <translation>推定値の光軸方向のドリフト</translation>
    </message>
    <message>
        <source>Error after a jump of the object</source>
        <translation>物体のジャンプ後の誤差</translation>
    </message>
    <message>
        <source>Particles from above</source>
        <translation>上から見た粒子</translation>
    </message>
    <message>
        <source>Particles in both camera images</source>
        <translation>両カメラ画像の粒子</translation>
    </message>
    <message>
        <source>The particle cloud over time</source>
        <translation>時間とともに動く粒子の雲</translation>
    </message>
    <message>
        <source>Motion masks and motion likelihood</source>
        <translation>動きのマスクと動きの尤度</translation>
    </message>
    <message>
        <source>Box tracking: error, success and precision</source>
        <translation>枠の追跡：誤差、成功率、精度</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet, stop and walk back.</source>
        <translation>Mohedano ら 2009：2 人が出会い、立ち止まり、引き返します。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people walk close to each other.</source>
        <translation>Mohedano ら 2009：2 人が近くを並んで歩きます。</translation>
    </message>
    <message>
        <source>People side by side</source>
        <translation>並んで歩く人</translation>
    </message>
    <message>
        <source>People whose paths cross</source>
        <translation>すれ違う人</translation>
    </message>
    <message>
        <source>People who enter and leave</source>
        <translation>入って出て行く人</translation>
    </message>
    <message>
        <source>People who meet and turn back</source>
        <translation>出会って引き返す人</translation>
    </message>
    <message>
        <source>People who stay apart</source>
        <translation>離れたままの人々</translation>
    </message>
    <message>
        <source>Barrera et al. 2005: a ball in space</source>
        <translation>Barrera ら 2005：空間中のボール</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009: boxes in the images of one camera</source>
        <translation>Sugandi ら 2009：1 台のカメラの画像での枠</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people</source>
        <translation>Mohedano ら 2009：人物</translation>
    </message>
    <message>
        <source>More scenes of people</source>
        <translation>その他の人物の場面</translation>
    </message>
    <message>
        <source>People of different heights</source>
        <translation>身長の異なる人</translation>
    </message>
    <message>
        <source>People who sit and crouch</source>
        <translation>座る人としゃがむ人</translation>
    </message>
    <message>
        <source>One person sits down on a stool and rises, one crouches and rises, and one walks by.</source>
        <translation>1 人がスツールに座って立ち上がり、1 人がしゃがんで立ち上がり、1 人が通り過ぎます。</translation>
    </message>
    <message>
        <source>People who carry objects</source>
        <translation>物を運ぶ人</translation>
    </message>
    <message>
        <source>Two people walk past each other, one with a box in front of the chest, one with a bag.</source>
        <translation>2 人がすれ違います。1 人は胸の前に箱を、1 人はかばんを持っています。</translation>
    </message>
    <message>
        <source>A crowd</source>
        <translation>人混み</translation>
    </message>
    <message>
        <source>Five to eight people walk about for 12 s; their paths may touch and cross.</source>
        <translation>5～8 人が 12 秒間動き回ります。進路は触れたり交わったりします。</translation>
    </message>
    <message>
        <source>People seen by two cameras</source>
        <translation>2 台のカメラに映る人</translation>
    </message>
    <message>
        <source>Two people walk past each other, seen by only two of the four cameras.</source>
        <translation>2 人がすれ違います。4 台のカメラのうち 2 台だけに映ります。</translation>
    </message>
    <message>
        <source>Two people come within 0.15 to 0.28 m of each other, stand there, and go back.</source>
        <translation>2 人が 0.15～0.28 m まで近づき、立ち止まって戻ります。</translation>
    </message>
    <message>
        <source>Furniture that moves</source>
        <translation>動く家具</translation>
    </message>
    <message>
        <source>A cabinet and a stool are moved after the cameras have learned the background.</source>
        <translation>カメラが背景を学習した後で、戸棚とスツールが動かされます。</translation>
    </message>
    <message>
        <source>Clothes in the room&apos;s colors</source>
        <translation>部屋と同じ色の服</translation>
    </message>
    <message>
        <source>Two people whose clothes have the colors of walls, furniture and floor walk past each other.</source>
        <translation>壁、家具、床と同じ色の服を着た 2 人がすれ違います。</translation>
    </message>
    <message>
        <source>Patterned clothes</source>
        <translation>柄のある服</translation>
    </message>
    <message>
        <source>Two people in striped, checked or blotched shirts walk past each other.</source>
        <translation>縞、格子、斑の柄のシャツを着た 2 人がすれ違います。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 7: the error after the jump of figure 6, for motion sigmas from 0.001 to 0.3 m, drawn as an image.</source>
        <translation>Barrera ら 2005、図7：図6の移動の後の誤差を、モーションシグマ0.001〜0.3 mについて画像として描きます。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 8: the cloud in six iterations, with a small and with a large motion sigma.</source>
        <translation>Barrera ら 2005、図8：小さいモーションシグマと大きいモーションシグマでの、6回の反復における雲。</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: the share of runs that converge, for start volumes of different sizes, and for start points at different distances behind the ball.</source>
        <translation>Barrera ら 2005、III-B節：収束した実行の割合。開始体積の大きさと、開始点からその手前のボールまでの距離を変えて示します。</translation>
    </message>
    <message>
        <source>Error after each iteration, for different motion sigmas</source>
        <translation>反復ごとの誤差（さまざまなモーションシグマ）</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people enter and leave. Measures how long an estimate exists where nobody is, and how long a person has no estimate.</source>
        <translation>Mohedano ら 2009：人が出入りします。人がいないのに推定がある時間と、人がいるのに推定がない時間を測ります。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people far apart. This is the easy case: no method should mix them up.</source>
        <translation>Mohedano ら 2009：互いに離れた 2 人。易しい場合で、どの手法も取り違えてはなりません。</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet and walk on. A method that uses only motion may mix them up; color tells them apart if their clothes differ.</source>
        <translation>Mohedano ら 2009：2 人が出会って通り過ぎます。動きだけを使う手法は取り違えることがありますが、服が違えば色で区別できます。</translation>
    </message>
    <message>
        <source>People who come close to each other</source>
        <translation>互いに近づく人</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009, section 4: compares method sugandi with 100 and with 300 particles, method histogram, and four trackers of OpenCV, all on the same clips.</source>
        <translation>Sugandi ら 2009、第 4 節：粒子 100 個と 300 個の手法 sugandi、手法 histogram、OpenCV の 4 つの追跡器を、すべて同じ映像で比べます。</translation>
    </message>
    <message>
        <source>Three people walk about: a child 0.9 to 1.3 m tall, a person 1.3 to 1.6 m tall and a person 1.88 to 2 m tall.</source>
        <translation>3 人が歩き回ります。身長 0.9〜1.3 m の子ども、1.3〜1.6 m の人、1.88〜2 m の人です。</translation>
    </message>
    <message>
        <source>Where a single camera finds the color</source>
        <translation>カメラ1台で色が見つかる場所</translation>
    </message>
    <message>
        <source>From which starting positions the particles still find the target</source>
        <translation>どの開始位置からなら、粒子がターゲットを見つけられるか</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>CSV, one row per target and time</source>
        <translation>CSV（ターゲットと時刻ごとに1行）</translation>
    </message>
    <message>
        <source>CSV, one row per time (spreadsheets)</source>
        <translation>CSV（時刻ごとに1行、表計算用）</translation>
    </message>
    <message>
        <source>TUM (evo)</source>
        <translation>TUM（evo）</translation>
    </message>
    <message>
        <source>TRC (OpenSim)</source>
        <translation>TRC（OpenSim）</translation>
    </message>
    <message>
        <source>C3D (motion capture)</source>
        <translation>C3D（モーションキャプチャ）</translation>
    </message>
    <message>
        <source>NPZ (NumPy)</source>
        <translation>NPZ（NumPy）</translation>
    </message>
    <message>
        <source>VTP (ParaView, paths)</source>
        <translation>VTP（ParaView、軌跡）</translation>
    </message>
    <message>
        <source>PVD (ParaView, over time)</source>
        <translation>PVD（ParaView、時系列）</translation>
    </message>
    <message>
        <source>JSON lines</source>
        <translation>JSON 行形式</translation>
    </message>
    <message>
        <source>Z points up, axes as in the project</source>
        <translation>Z が上向き、軸はプロジェクトと同じ</translation>
    </message>
    <message>
        <source>Lengths in %1, times in s, covariances in %1². %2.</source>
        <translation>長さは %1、時刻は s、共分散は %1²。%2。</translation>
    </message>
    <message>
        <source>no gaps</source>
        <translation>欠落なし</translation>
    </message>
    <message>
        <source>%1 positions unknown</source>
        <translation>不明な位置 %1</translation>
    </message>
    <message>
        <source>Targets: %1, rows: %2 at %3 per second, %4.</source>
        <translation>ターゲット: %1、行: %2（毎秒 %3）、%4。</translation>
    </message>
    <message>
        <source>Y points up: x, y, z of the file are y, z, x of the project</source>
        <translation>Y が上向き: ファイルの x, y, z はプロジェクトの y, z, x</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Wrote the figure %1.</source>
        <translation>図 %1 を書き出しました。</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2 files; the last is %3.</source>
        <translation>%1 行を %2 個のファイルに書き出しました。最後は %3 です。</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2.</source>
        <translation>%1 行を %2 に書き出しました。</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 と %2 の姿勢が同じです。</translation>
    </message>
    <message>
        <source>%1 has %2 frames of %3 pixels, %4.</source>
        <translation>%1: %2 フレーム、%3 ピクセル、%4。</translation>
    </message>
    <message>
        <source>%1 is %2 m below the floor (z = 0).</source>
        <translation>%1 が床（z = 0）より %2 m 下にあります。</translation>
    </message>
    <message>
        <source>The view of %1 does not overlap with the view of any other camera.</source>
        <translation>%1 の視野は、ほかのどのカメラの視野とも重なりません。</translation>
    </message>
    <message>
        <source>A file of the project is missing: %1.</source>
        <translation>プロジェクトのファイルがありません: %1。</translation>
    </message>
    <message>
        <source>According to their tables of times, the cameras never recorded at the same time.</source>
        <translation>時刻の表によると、カメラが同時に録画していた時間がありません。</translation>
    </message>
    <message>
        <source>Add a target, or choose a method that finds targets by itself.</source>
        <translation>ターゲットを追加するか、ターゲットを自動で見つける手法を選んでください。</translation>
    </message>
    <message>
        <source>Add cameras, or choose another method.</source>
        <translation>カメラを追加するか、別の手法を選んでください。</translation>
    </message>
    <message>
        <source>Calibrate both cameras again; the pose of one was probably copied from the other.</source>
        <translation>両方のカメラのキャリブレーションをやり直してください。おそらく一方の姿勢が他方にコピーされています。</translation>
    </message>
    <message>
        <source>Calibrate the cameras with a board, a wand or measured points.</source>
        <translation>ボード、ワンド、または測った点でカメラをキャリブレーションしてください。</translation>
    </message>
    <message>
        <source>Calibrate the cameras, or choose a method that tracks boxes in images.</source>
        <translation>カメラをキャリブレーションするか、画像の中の枠を追跡する手法を選んでください。</translation>
    </message>
    <message>
        <source>In the project file, check the value of late_by for this camera. It is in seconds.</source>
        <translation>プロジェクトファイルで、このカメラの late_by の値を確かめてください。単位は秒です。</translation>
    </message>
    <message>
        <source>Check that the camera sees the target, and check its exposure and white balance.</source>
        <translation>カメラにターゲットが写っているか、露光とホワイトバランスが適切かを確かめてください。</translation>
    </message>
    <message>
        <source>Check that the time stamps of all cameras (in their tables of times) are from the same clock.</source>
        <translation>すべてのカメラのタイムスタンプ（時刻表にあるもの）が同じ時計によるものか確認してください。</translation>
    </message>
    <message>
        <source>Check that the corrections were made for this recording.</source>
        <translation>この録画のための修正かどうか確かめてください。</translation>
    </message>
    <message>
        <source>Check that z points up and is 0 on the floor, unless you placed the origin elsewhere.</source>
        <translation>原点を別の場所に置いた場合を除き、z が上向きで、床で 0 になることを確かめてください。</translation>
    </message>
    <message>
        <source>Click the target in an image, or use the command learn-color.</source>
        <translation>画像の中でターゲットをクリックするか、learn-color コマンドを使ってください。</translation>
    </message>
    <message>
        <source>Convert the recordings to the same frame rate, or give each camera a table of times.</source>
        <translation>録画を同じフレームレートに変換するか、各カメラに時刻の表を指定してください。</translation>
    </message>
    <message>
        <source>Copy the recording again, or convert it with FFmpeg.</source>
        <translation>録画をコピーし直すか、FFmpeg で変換してください。</translation>
    </message>
    <message>
        <source>Copy the video again, or repair it with FFmpeg (ffmpeg -i IN -c copy OUT).</source>
        <translation>動画をコピーし直すか、FFmpeg で修復してください（ffmpeg -i 入力 -c copy 出力）。</translation>
    </message>
    <message>
        <source>Copy the image folder again; otherwise the camera has no image in the missing frames.</source>
        <translation>画像フォルダーをコピーし直してください。このままでは、欠けているフレームにこのカメラの画像がありません。</translation>
    </message>
    <message>
        <source>Copy the recording again, or use only the frames before the unreadable one.</source>
        <translation>録画をコピーし直すか、読めないフレームより前のフレームだけを使ってください。</translation>
    </message>
    <message>
        <source>In the project file, correct the value of late_by for this camera. It is in seconds.</source>
        <translation>プロジェクトファイルで、このカメラの late_by の値を直してください。単位は秒です。</translation>
    </message>
    <message>
        <source>Correct the file of true positions, or remove the key &apos;truth&apos; from the project file.</source>
        <translation>真の位置のファイルを直すか、プロジェクトファイルからキー「truth」を削除してください。</translation>
    </message>
    <message>
        <source>Correct the project file in a text editor, or make a new project.</source>
        <translation>テキストエディターでプロジェクトファイルを直すか、新しいプロジェクトを作成してください。</translation>
    </message>
    <message>
        <source>Correct the table of times, or remove this camera&apos;s key &apos;times&apos; from the project file.</source>
        <translation>時刻の表を直すか、プロジェクトファイルからこのカメラのキー「times」を削除してください。</translation>
    </message>
    <message>
        <source>The project has corrections for frames that the recording does not have: %1.</source>
        <translation>プロジェクトに、録画にないフレームの修正があります: %1。</translation>
    </message>
    <message>
        <source>Draw the box in an earlier frame.</source>
        <translation>もっと前のフレームで枠を引いてください。</translation>
    </message>
    <message>
        <source>Draw a box around the target in an image.</source>
        <translation>画像の中で、ターゲットを枠で囲んでください。</translation>
    </message>
    <message>
        <source>Frame %2 of %1 cannot be read: %3.</source>
        <translation>%1 のフレーム %2 を読み込めません: %3。</translation>
    </message>
    <message>
        <source>Give a table of times to every camera, or to none.</source>
        <translation>すべてのカメラに時刻の表を指定するか、どのカメラにも指定しないでください。</translation>
    </message>
    <message>
        <source>Give the radius in meters.</source>
        <translation>半径をメートルで指定してください。</translation>
    </message>
    <message>
        <source>Import the calibration again, or calibrate the cameras again.</source>
        <translation>キャリブレーションをインポートし直すか、カメラのキャリブレーションをやり直してください。</translation>
    </message>
    <message>
        <source>Import the calibration again with the right unit (calibration convert --unit).</source>
        <translation>正しい単位でキャリブレーションをインポートし直してください（calibration convert --unit）。</translation>
    </message>
    <message>
        <source>In the first %1 s, the images do not fit the calibration: %2.</source>
        <translation>最初の %1 s で、画像がキャリブレーションと合いません: %2。</translation>
    </message>
    <message>
        <source>Judging by the numbers in the file names, %2 of %3 images of %1 are missing, the first one after %4.</source>
        <translation>ファイル名の番号によると、%1 の画像が %3 枚中 %2 枚足りません。最初に欠けているのは %4 の次の画像です。</translation>
    </message>
    <message>
        <source>Learn the color again in an image of this recording.</source>
        <translation>この録画の画像で色を学習し直してください。</translation>
    </message>
    <message>
        <source>Learn the color again, with samples that do not reach beyond the target.</source>
        <translation>ターゲットからはみ出さない見本で、色を学習し直してください。</translation>
    </message>
    <message>
        <source>Learn the color again.</source>
        <translation>色を学習し直してください。</translation>
    </message>
    <message>
        <source>Make one project of the live cameras and another one of the recordings.</source>
        <translation>ライブカメラと録画を別々のプロジェクトに分けてください。</translation>
    </message>
    <message>
        <source>Free some disk space, or write to another disk with the option --out.</source>
        <translation>空きを増やすか、オプション --out で別のディスクに書き出してください。</translation>
    </message>
    <message>
        <source>Move the volume of interest, or remove it.</source>
        <translation>探索範囲を動かすか、削除してください。</translation>
    </message>
    <message>
        <source>No part of the volume of interest is seen by enough cameras (at least %1 are needed).</source>
        <translation>探索範囲のどの部分も、必要な台数のカメラ（%1 台以上）から見えません。</translation>
    </message>
    <message>
        <source>No pixel can have the color of target %1: the color range is too narrow.</source>
        <translation>ターゲット %1 の色の範囲が狭すぎて、どのピクセルも一致しません。</translation>
    </message>
    <message>
        <source>Nothing can be tracked: %1.</source>
        <translation>何も追跡できません: %1。</translation>
    </message>
    <message>
        <source>Nothing can be written to the folder of the project.</source>
        <translation>プロジェクトのフォルダーに書き込めません。</translation>
    </message>
    <message>
        <source>Only %1 GB are free for results.</source>
        <translation>結果を保存する空きが %1 GB しかありません。</translation>
    </message>
    <message>
        <source>Only %1 MB are free for results.</source>
        <translation>結果を保存する空きが %1 MB しかありません。</translation>
    </message>
    <message>
        <source>Only the first %2 frames of each recording are used; check that all recordings begin at the same time.</source>
        <translation>各録画の最初の %2 フレームだけを使います。すべての録画が同時に始まることを確かめてください。</translation>
    </message>
    <message>
        <source>Open the project to see whether images arrive.</source>
        <translation>プロジェクトを開いて、画像が届くか確かめてください。</translation>
    </message>
    <message>
        <source>Other cameras have a table of times, but %1 has none.</source>
        <translation>ほかのカメラには時刻の表がありますが、%1 にはありません。</translation>
    </message>
    <message>
        <source>Connect the device, or choose another one.</source>
        <translation>デバイスを接続するか、別のデバイスを選んでください。</translation>
    </message>
    <message>
        <source>Put the missing file or folder back, or correct its path in the project file.</source>
        <translation>見つからないファイルまたはフォルダーを元の場所に戻すか、プロジェクトファイルのパスを直してください。</translation>
    </message>
    <message>
        <source>Remove frames_per_second from the project file, unless the rate stated in the video is wrong.</source>
        <translation>動画に書かれた値が誤っている場合を除き、プロジェクトファイルから frames_per_second を削除してください。</translation>
    </message>
    <message>
        <source>Set frames_per_second in the project file; the measured speeds depend on it.</source>
        <translation>プロジェクトファイルで frames_per_second を設定してください。測定される速度に影響します。</translation>
    </message>
    <message>
        <source>In the project file, set the key &apos;rotate&apos; of this camera to 90 or 270.</source>
        <translation>プロジェクトファイルで、このカメラのキー「rotate」を 90 か 270 にしてください。</translation>
    </message>
    <message>
        <source>Simulated cameras: %1.</source>
        <translation>シミュレーションのカメラは %1 台です。</translation>
    </message>
    <message>
        <source>Solve this problem, then check again.</source>
        <translation>示された問題を解決してから、もう一度チェックしてください。</translation>
    </message>
    <message>
        <source>Some cameras are live and others are recordings.</source>
        <translation>ライブカメラと録画が混在しています。</translation>
    </message>
    <message>
        <source>Take the background image again, or remove this camera&apos;s key &apos;empty_room&apos; from the project file.</source>
        <translation>背景画像を撮り直すか、プロジェクトファイルからこのカメラのキー「empty_room」を削除してください。</translation>
    </message>
    <message>
        <source>Target %1 has a radius of %2 m, which is larger than a person.</source>
        <translation>ターゲット %1 の半径は %2 m で、人よりも大きくなります。</translation>
    </message>
    <message>
        <source>Target %1 has no box to start from.</source>
        <translation>ターゲット %1 に、追跡を始めるための枠がありません。</translation>
    </message>
    <message>
        <source>Target %1 has no color yet.</source>
        <translation>ターゲット %1 の色がまだありません。</translation>
    </message>
    <message>
        <source>The background image of %1 cannot be used: %2.</source>
        <translation>%1 の背景画像は使えません: %2。</translation>
    </message>
    <message>
        <source>The box of target %1 is in frame %2, but the last frame is frame %3.</source>
        <translation>ターゲット %1 の枠はフレーム %2 にありますが、最後のフレームは %3 です。</translation>
    </message>
    <message>
        <source>The calibration cannot be right: %1.</source>
        <translation>キャリブレーションが正しくありません: %1。</translation>
    </message>
    <message>
        <source>The calibration is plausible (cameras: %1, largest distance between them: %2 m).</source>
        <translation>カメラ %1 台のキャリブレーションは妥当です。カメラどうしの距離は最大 %2 m です。</translation>
    </message>
    <message>
        <source>The cameras are %1 m apart: their positions are probably in units of %2 m.</source>
        <translation>カメラどうしが %1 m 離れています。位置はおそらく %2 m を単位としています。</translation>
    </message>
    <message>
        <source>The cameras are not calibrated: their poses are guesses, so tracked positions mean nothing.</source>
        <translation>カメラがキャリブレーションされていません。姿勢が仮のものなので、追跡した位置に意味はありません。</translation>
    </message>
    <message>
        <source>In the images of %3, %2 % of all pixels have the color of target %1.</source>
        <translation>%3 の画像では、全ピクセルの %2 % がターゲット %1 の色です。</translation>
    </message>
    <message>
        <source>In the images, %2 % of all pixels have the color of target %1.</source>
        <translation>画像では、全ピクセルの %2 % がターゲット %1 の色です。</translation>
    </message>
    <message>
        <source>The color of target %1 was not found in any of the %2 checked images.</source>
        <translation>調べた %2 枚の画像のどれにも、ターゲット %1 の色が見つかりませんでした。</translation>
    </message>
    <message>
        <source>The color of target %1 was not found in any of the checked images of %2.</source>
        <translation>%2 の調べた画像のどれにも、ターゲット %1 の色が見つかりませんでした。</translation>
    </message>
    <message>
        <source>The delay of %1 is %2 s, which is unusually large.</source>
        <translation>%1 の遅れは %2 s です。普通より大きな値です。</translation>
    </message>
    <message>
        <source>The delay of %1 (%2 s) is longer than its recording, so this camera has no image in any frame.</source>
        <translation>%1 の遅れ（%2 s）は録画の長さを超えているため、このカメラの画像はどのフレームにもありません。</translation>
    </message>
    <message>
        <source>The device of %1 is connected.</source>
        <translation>%1 のデバイスは接続されています。</translation>
    </message>
    <message>
        <source>The device of %1 is not connected: %2.</source>
        <translation>%1 のデバイスが接続されていません: %2。</translation>
    </message>
    <message>
        <source>The frame rate of the images is not given; %1 frames per second are assumed.</source>
        <translation>画像のフレームレートがどこにも書かれていません。毎秒 %1 フレームと仮定します。</translation>
    </message>
    <message>
        <source>The images of %1 have %2 pixels, but its calibration is for %3.</source>
        <translation>%1 の画像は %2 ピクセルですが、キャリブレーションは %3 用です。</translation>
    </message>
    <message>
        <source>The method %1 can work with this project.</source>
        <translation>手法 %1 はこのプロジェクトで使えます。</translation>
    </message>
    <message>
        <source>The method %1 needs at least %2 cameras; this project has %3.</source>
        <translation>手法 %1 には %2 台以上のカメラが必要ですが、%3 台しかありません。</translation>
    </message>
    <message>
        <source>The method %1 needs calibrated cameras.</source>
        <translation>手法 %1 にはキャリブレーション済みのカメラが必要です。</translation>
    </message>
    <message>
        <source>The project can be read.</source>
        <translation>プロジェクトを読み込めます。</translation>
    </message>
    <message>
        <source>The project cannot be opened: %1.</source>
        <translation>プロジェクトを開けません: %1。</translation>
    </message>
    <message>
        <source>The project cannot be read: %1.</source>
        <translation>プロジェクトを読み込めません: %1。</translation>
    </message>
    <message>
        <source>The project says %1 frames per second, but the video of %2 has %3.</source>
        <translation>プロジェクトでは毎秒 %1 フレームですが、%2 の動画は毎秒 %3 フレームです。</translation>
    </message>
    <message>
        <source>The recording of %1 cannot be opened: %2.</source>
        <translation>%1 の録画を開けません: %2。</translation>
    </message>
    <message>
        <source>The recording of %1 is missing: %2.</source>
        <translation>%1 の録画がありません: %2。</translation>
    </message>
    <message>
        <source>The recordings differ in length: %1.</source>
        <translation>録画の長さが異なります: %1。</translation>
    </message>
    <message>
        <source>The recordings have different frame rates: %1.</source>
        <translation>録画のフレームレートが異なります: %1。</translation>
    </message>
    <message>
        <source>The stream of %1 was not tested: the check opens no network connections.</source>
        <translation>%1 の映像は試していません。チェックではネットワークに接続しません。</translation>
    </message>
    <message>
        <source>The table of times of %1 cannot be used: %2.</source>
        <translation>%1 の時刻の表は使えません: %2。</translation>
    </message>
    <message>
        <source>The table of times of %1 has %2 times, but there are %3 images.</source>
        <translation>%1 の時刻の表には時刻が %2 個ありますが、画像は %3 枚です。</translation>
    </message>
    <message>
        <source>The true positions cannot be read: %1.</source>
        <translation>真の位置を読み込めません: %1。</translation>
    </message>
    <message>
        <source>The video of %1 is cut off: %2.</source>
        <translation>%1 の動画が途中で切れています: %2。</translation>
    </message>
    <message>
        <source>There is enough disk space for results: %1 GB are free.</source>
        <translation>結果を保存するディスクの空きは十分です: %1 GB。</translation>
    </message>
    <message>
        <source>Turn this camera toward the target, or calibrate it again.</source>
        <translation>このカメラをターゲットに向けるか、キャリブレーションをやり直してください。</translation>
    </message>
    <message>
        <source>Use a calibration for images of this size, or record images of the calibrated size.</source>
        <translation>この大きさの画像用のキャリブレーションを使うか、キャリブレーションした大きさで録画してください。</translation>
    </message>
    <message>
        <source>Use the table of times that belongs to this recording.</source>
        <translation>この録画に対応する時刻の表を使ってください。</translation>
    </message>
    <message>
        <source>Write the results to another folder with the option --out.</source>
        <translation>オプション --out で別のフォルダーに結果を書き出してください。</translation>
    </message>
    <message>
        <source>When the color of target %1 was learned, %2 % of its pixels in %3 were overexposed.</source>
        <translation>ターゲット %1 の色を学習したとき、%3 ではそのピクセルの %2 % が露出オーバーでした。</translation>
    </message>
    <message>
        <source>When the color of target %1 was learned, %2 % of its pixels in %3 were too dark.</source>
        <translation>ターゲット %1 の色を学習したとき、%3 ではそのピクセルの %2 % が暗すぎました。</translation>
    </message>
    <message>
        <source>Lower the exposure of the camera, and learn the color again in new images.</source>
        <translation>カメラの露出を下げ、新しい画像で色を学習し直してください。</translation>
    </message>
    <message>
        <source>Raise the exposure of the camera or add light, and learn the color again in new images.</source>
        <translation>カメラの露出を上げるか照明を追加し、新しい画像で色を学習し直してください。</translation>
    </message>
</context>
<context>
    <name>FindingText</name>
    <message>
        <source>camera “%1”</source>
        <translation>カメラ「%1」</translation>
    </message>
</context>
<context>
    <name>GlContext</name>
    <message>
        <source>no OpenGL context can be made on this display</source>
        <translation>この画面では OpenGL コンテキストを作成できません</translation>
    </message>
    <message>
        <source>the OpenGL context cannot be used</source>
        <translation>OpenGL コンテキストを使用できません</translation>
    </message>
    <message>
        <source>OpenGL 3.2 is needed</source>
        <translation>OpenGL 3.2 が必要です</translation>
    </message>
</context>
<context>
    <name>GuideText</name>
    <message>
        <source>guessed</source>
        <translation>推測</translation>
    </message>
    <message>
        <source>exact (simulated)</source>
        <translation>正確(シミュレーション)</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>手動設定</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>計測点</translation>
    </message>
    <message>
        <source>board</source>
        <translation>ボード</translation>
    </message>
    <message>
        <source>wand</source>
        <translation>ワンド</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>ファイルから</translation>
    </message>
    <message>
        <source>points marked in the images</source>
        <translation>画像内でマークした点</translation>
    </message>
    <message>
        <source>%1, ±%2</source>
        <translation>%1、±%2</translation>
    </message>
    <message>
        <source>By hand: fit a drawn grid to the images</source>
        <translation>手動：描いた格子を画像に合わせる</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>計測点</translation>
    </message>
    <message>
        <source>Printed board</source>
        <translation>印刷したボード</translation>
    </message>
    <message>
        <source>Wand: a ball, or a stick with two balls</source>
        <translation>ワンド: ボール 1 個、またはボール 2 個付きの棒</translation>
    </message>
    <message>
        <source>File of another program</source>
        <translation>他のプログラムのファイル</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Import the file</source>
        <translation>ファイルを読み込む</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>キャリブレーションを読み込む…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>印刷</translation>
    </message>
    <message>
        <source>Print a board</source>
        <translation>ボードを印刷する</translation>
    </message>
    <message>
        <source>Go to the page Board</source>
        <translation>「ボード」ページへ</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>レンズ</translation>
    </message>
    <message>
        <source>Calibrate the lenses</source>
        <translation>レンズをキャリブレーションする</translation>
    </message>
    <message>
        <source>Set the field of view</source>
        <translation>視野角を設定する</translation>
    </message>
    <message>
        <source>Go to the page By hand</source>
        <translation>「手動」ページへ</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>Lay the grid over the room</source>
        <translation>格子を部屋に重ねる</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Measure points and click them</source>
        <translation>点を計測してクリックする</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Compute the cameras</source>
        <translation>カメラを計算する</translation>
    </message>
    <message>
        <source>Find the camera positions</source>
        <translation>カメラの位置を求める</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>概略</translation>
    </message>
    <message>
        <source>Place the cameras roughly</source>
        <translation>カメラをおおまかに配置する</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>ボール</translation>
    </message>
    <message>
        <source>Learn the color of the ball</source>
        <translation>ボールの色を学習する</translation>
    </message>
    <message>
        <source>Click the ball in an image. For a stick with two balls, learn two targets of different colors.</source>
        <translation>画像内のボールをクリックします。ボール 2 個付きの棒では、色の異なる 2 つのターゲットを学習します。</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>色を学習</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>振る</translation>
    </message>
    <message>
        <source>Wave the wand</source>
        <translation>ワンドを振る</translation>
    </message>
    <message>
        <source>Go to the page Wand</source>
        <translation>「ワンド」ページへ</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>Set floor and origin</source>
        <translation>床と原点を設定する</translation>
    </message>
    <message>
        <source>Go to the page Floor</source>
        <translation>「床」ページへ</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Check a measured length</source>
        <translation>計測した長さを確かめる</translation>
    </message>
    <message>
        <source>Not done yet.</source>
        <translation>まだ完了していません。</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>完了。</translation>
    </message>
    <message>
        <source>the z axis does not seem to point up</source>
        <translation>z 軸が上を向いていないようです</translation>
    </message>
    <message>
        <source>%1, ±%2: too inaccurate</source>
        <translation>%1、±%2: 誤差が大きすぎます</translation>
    </message>
    <message>
        <source>You need one known length, such as the length of a table or of a floor tile. You get a first result within minutes.</source>
        <translation>テーブルや床タイルの長さなど、わかっている長さが 1 つ必要です。数分で最初の結果が得られます。</translation>
    </message>
    <message>
        <source>You need a printed board that you can carry through the room. This is the most accurate way to calibrate the lenses.</source>
        <translation>部屋の中を持ち運べる印刷したボードが必要です。レンズを最も正確にキャリブレーションできる方法です。</translation>
    </message>
    <message>
        <source>You need rough camera positions and a ball to wave. This is the most accurate way to find the camera positions in a large room.</source>
        <translation>カメラのおおよその位置と、振るためのボールが必要です。広い部屋でカメラの位置を最も正確に求められる方法です。</translation>
    </message>
    <message>
        <source>You need a calibration file for these cameras and for images of this size.</source>
        <translation>これらのカメラと、この画像サイズのためのキャリブレーションファイルが必要です。</translation>
    </message>
    <message>
        <source>Choose the file. If something is missing in the file, such as the unit, the dialog asks you for it. The dialog also shows how far each camera would move.</source>
        <translation>ファイルを選びます。単位などファイルに含まれないものは、ダイアログが尋ねます。各カメラがどれだけ動くかも表示されます。</translation>
    </message>
    <message>
        <source>Describe the board on the page Board, and print it at 100 %. Check the scale bar with a ruler, and glue the sheet to something stiff and flat. If you already have a board, just describe it and go on to the next step.</source>
        <translation>「ボード」ページでボードを記述し、100 % で印刷します。目盛りを定規で確かめ、硬くて平らなものに貼ります。すでにボードがあれば、記述だけして次のステップへ進みます。</translation>
    </message>
    <message>
        <source>On the page Board, choose Intrinsics. With live cameras, press Start and show the board to each camera: close, tilted to all sides, and in the corners of the image. Hold it still each time. If you have already recorded this, just press Calibrate.</source>
        <translation>「ボード」ページで「内部パラメータ」を選びます。ライブカメラの場合は「開始」を押し、各カメラにボードを見せます: 近くで、あらゆる方向に傾けて、画像の隅でも。そのつど静止させます。すでに録画してある場合は「キャリブレーション」を押すだけです。</translation>
    </message>
    <message>
        <source>Enter the field of view or the focal length of each camera, for example from its data sheet. Calibrating the lens with a board is more accurate, but you do not need it to begin.</source>
        <translation>データシートなどから、各カメラの視野角または焦点距離を入力します。ボードでレンズをキャリブレーションするほうが正確ですが、始めるだけなら必要ありません。</translation>
    </message>
    <message>
        <source>Give the grid the size of a real object that you have measured. In each image, drag the grid until it lies on this object. Click a point of the grid to hold it in place.</source>
        <translation>格子を、実際に測った物の大きさにします。各画像で、その物に重なるまで格子をドラッグします。格子の点をクリックすると、その点が固定されます。</translation>
    </message>
    <message>
        <source>Add points whose positions in the room you have measured, in meters. Then click each point in the images. Each camera needs at least four points, or better six that do not all lie in one plane.</source>
        <translation>部屋の中で位置を測った点を、メートル単位で追加します。次に画像内で各点をクリックします。各カメラに少なくとも 4 点、できればすべてが同じ平面上にはない 6 点が必要です。</translation>
    </message>
    <message>
        <source>Press Compute cameras below the table of points. If a point fits badly, the page tells you which one.</source>
        <translation>点の表の下の「カメラを求める」を押します。合わない点があれば、どの点かがページに表示されます。</translation>
    </message>
    <message>
        <source>On the page Board, choose Camera positions. With live cameras, press Start and show the board to at least two cameras at a time, in many parts of the volume. Lay it on the floor once, and press Set floor from board. If you have already recorded this, enter the frame with the board on the floor and press Calibrate.</source>
        <translation>「ボード」ページで「カメラの位置」を選びます。ライブカメラの場合は「開始」を押し、空間のさまざまな場所で、同時に 2 台以上のカメラにボードを見せます。一度床に置き、「ボードで床を設定」を押します。すでに録画してある場合は、ボードが床に置かれているフレームを入力し、「キャリブレーション」を押します。</translation>
    </message>
    <message>
        <source>Drag the grid in each image, or the cameras in the bird&apos;s-eye view, until each camera is within about 12 cm of its real position.</source>
        <translation>各画像の格子、または鳥瞰図のカメラをドラッグし、各カメラを実際の位置から約 12 cm 以内に合わせます。</translation>
    </message>
    <message>
        <source>On the page Wand, choose what you wave and where the scale comes from. With live cameras, press Start waving and wave slowly through the whole volume for half a minute. Then press Refine cameras. If you have already recorded this, just press Refine cameras.</source>
        <translation>「ワンド」ページで、何を振るか、縮尺をどこから得るかを指定します。ライブカメラの場合は「振り始める」を押し、空間全体でゆっくり 30 秒ほど振ります。次に「カメラを精密化」を押します。すでに録画してある場合は「カメラを精密化」を押すだけです。</translation>
    </message>
    <message>
        <source>Mark three points of the floor as A, B and C, each in at least two images. A becomes the origin, and the x axis points from A to B. Then press Set floor from A, B and C.</source>
        <translation>床の 3 点を A、B、C として、それぞれ少なくとも 2 つの画像でマークします。A が原点になり、x 軸は A から B を向きます。次に「A、B、C から床を設定」を押します。</translation>
    </message>
    <message>
        <source>Measure a distance in the room, as long as possible. Mark its ends as A and B, enter the distance, and press Check. If the calibration gives a different distance, press Set scale to correct the calibration.</source>
        <translation>部屋の中でできるだけ長い距離を測ります。両端を A と B としてマークし、距離を入力して「確認」を押します。キャリブレーションの値が違う場合は、「縮尺を設定」を押してキャリブレーションを直します。</translation>
    </message>
    <message>
        <source>Done: the distance in the calibration differs from the measured one by %1.</source>
        <translation>完了: キャリブレーションでの距離と測定した距離の差は %1 です。</translation>
    </message>
    <message>
        <source>Done for %1 of %2 cameras.</source>
        <translation>カメラ %2 台中 %1 台が完了。</translation>
    </message>
    <message>
        <source>Done for %1 of %2 cameras. The largest error is %3.</source>
        <translation>カメラ %2 台中 %1 台が完了。最大誤差は %3。</translation>
    </message>
    <message>
        <source>You need a tape measure and points that the cameras see: at least four for each camera, better six. Choose this for cameras that are mounted in a room.</source>
        <translation>巻き尺と、カメラに見える点が必要です。カメラごとに少なくとも 4 点、できれば 6 点です。部屋に固定したカメラに向いた方法です。</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>%1 or more</source>
        <translation>%1台以上</translation>
    </message>
    <message>
        <source>blank: seen by fewer than two cameras</source>
        <translation>空白：見えるカメラが2台未満</translation>
    </message>
    <message>
        <source>Cameras that see a point</source>
        <translation>点が見えるカメラの数</translation>
    </message>
    <message>
        <source>Expected error (1 σ)</source>
        <translation>予想誤差（1 σ）</translation>
    </message>
    <message>
        <source>blank: seen by no camera</source>
        <translation>空白：見えるカメラなし</translation>
    </message>
</context>
<context>
    <name>MapOverlay</name>
    <message>
        <source>Cameras that see this point: %1</source>
        <translation>この点が見えるカメラ：%1台</translation>
    </message>
    <message>
        <source>Expected error: ±%1 (1 σ); cameras that see this point: %2</source>
        <translation>予想誤差：±%1（1 σ）、この点が見えるカメラ：%2台</translation>
    </message>
</context>
<context>
    <name>Method</name>
    <message>
        <source>Any object in the images of one camera (2D)</source>
        <translation>1 台のカメラの画像の中の任意の物体（2D）</translation>
    </message>
    <message>
        <source>A particle filter with color histograms</source>
        <translation>色ヒストグラムの粒子フィルター</translation>
    </message>
    <message>
        <source>A particle filter with position measurements</source>
        <translation>位置の測定による粒子フィルター</translation>
    </message>
    <message>
        <source>A simple particle filter with color</source>
        <translation>色の単純な粒子フィルター</translation>
    </message>
    <message>
        <source>Colored objects in 3D</source>
        <translation>色のついた物体を 3D で</translation>
    </message>
    <message>
        <source>Anything you draw a box around</source>
        <translation>枠で囲んだ物なら何でも</translation>
    </message>
    <message>
        <source>Balls, hands and other colored objects</source>
        <translation>ボール、手など色のついた物体</translation>
    </message>
    <message>
        <source>For comparison: mixes up people who come close to each other.</source>
        <translation>比較用：近づいた人を取り違えます。</translation>
    </message>
    <message>
        <source>For comparison: distinguishes people by their clothes.</source>
        <translation>比較用：人を服で区別します。</translation>
    </message>
    <message>
        <source>For teaching: tracks an object as a box in the images of one camera.</source>
        <translation>教育用：1 台のカメラの画像の中の物体を枠で追跡します。</translation>
    </message>
    <message>
        <source>For teaching: shows how a particle filter works.</source>
        <translation>教育用：粒子フィルターの仕組みを示します。</translation>
    </message>
    <message>
        <source>For teaching: shows how particles follow measured positions.</source>
        <translation>教育用：粒子が、測定された位置を追う様子を示します。</translation>
    </message>
    <message>
        <source>From papers, for teaching and comparison</source>
        <translation>論文の手法（教育と比較のために）</translation>
    </message>
    <message>
        <source>People by motion alone</source>
        <translation>動きだけによる人物</translation>
    </message>
    <message>
        <source>People by motion and color</source>
        <translation>動きと色による人物</translation>
    </message>
    <message>
        <source>People in a room</source>
        <translation>部屋の中の人物</translation>
    </message>
    <message>
        <source>People who walk and meet</source>
        <translation>歩き、出会う人物</translation>
    </message>
    <message>
        <source>Tracks several people on the floor, even in similar clothes.</source>
        <translation>似た服を着ていても、床の上の複数の人物を追跡します。</translation>
    </message>
    <message>
        <source>The most accurate method. It finds out by itself whether the target is a ball or has another shape.</source>
        <translation>最も正確な手法です。ターゲットがボールかほかの形かを自動で判断します。</translation>
    </message>
    <message>
        <source>Tracks an object by its colors, adapts to its size, and finds it again after it was hidden.</source>
        <translation>物体を色で追跡し、大きさの変化に合わせ、隠れた後も見つけ直します。</translation>
    </message>
</context>
<context>
    <name>MethodObstacle</name>
    <message>
        <source>Needs calibrated cameras.</source>
        <translation>キャリブレーション済みのカメラが必要です。</translation>
    </message>
    <message>
        <source>Needs at least two cameras.</source>
        <translation>2 台以上のカメラが必要です。</translation>
    </message>
</context>
<context>
    <name>OutletText</name>
    <message>
        <source>JSON lines at %1</source>
        <translation>JSON 行（%1）</translation>
    </message>
    <message>
        <source>Web page and WebSocket at %1</source>
        <translation>ウェブページと WebSocket（%1）</translation>
    </message>
    <message>
        <source>OSC messages to %1</source>
        <translation>OSC メッセージの送信先 %1</translation>
    </message>
    <message>
        <source>TUIO cursors to %1</source>
        <translation>TUIO カーソルの送信先 %1</translation>
    </message>
    <message>
        <source>CSV lines to the standard output</source>
        <translation>CSV 行の出力先は標準出力</translation>
    </message>
    <message>
        <source>CSV lines to %1</source>
        <translation>CSV 行の出力先 %1</translation>
    </message>
    <message>
        <source>No program is reading this pipe.</source>
        <translation>このパイプを読み取っているプログラムがありません。</translation>
    </message>
    <message>
        <source>Nothing can be written: %1</source>
        <translation>書き込めません: %1</translation>
    </message>
</context>
<context>
    <name>PageText</name>
    <message>
        <source>Dewpoint live</source>
        <translation>Dewpoint ライブ</translation>
    </message>
    <message>
        <source>Cameras, targets and their tracks in 3D</source>
        <translation>カメラ、ターゲット、その軌跡の 3D 表示</translation>
    </message>
    <message>
        <source>Drag: rotate · Wheel or two fingers: zoom · Double click: reset</source>
        <translation>ドラッグ: 回転 · ホイールまたは 2 本指: ズーム · ダブルクリック: リセット</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>接続中…</translation>
    </message>
    <message>
        <source>Connected. Waiting for images…</source>
        <translation>接続しました。画像を待っています…</translation>
    </message>
    <message>
        <source>Not connected. Trying again…</source>
        <translation>接続されていません。再試行しています…</translation>
    </message>
    <message>
        <source>Frame %1, %2</source>
        <extracomment>%1 is the number of a frame, %2 its time</extracomment>
        <translation>フレーム %1、%2</translation>
    </message>
    <message>
        <source>tracking</source>
        <translation>追跡中</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>あいまい</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隠れている</translation>
    </message>
    <message>
        <source>searching</source>
        <translation>探索中</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>見失い</translation>
    </message>
    <message>
        <source>not present</source>
        <translation>不在</translation>
    </message>
    <message>
        <source>Only pages from this server can read the results.</source>
        <translation>結果を読み取れるのは、このサーバーのページだけです。</translation>
    </message>
    <message>
        <source>Only GET requests are supported.</source>
        <translation>GET リクエストのみ使用できます。</translation>
    </message>
    <message>
        <source>This server has only one page: /.</source>
        <translation>このサーバーのページは / だけです。</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Half the x size of the start box: the particles start evenly spread in this box; 0 starts them all at the same x.</source>
        <translation>開始点を囲む箱の x 方向の大きさの半分。粒子はこの箱の中に一様に散らばって始まります。0 ではすべて同じ x から始まります。</translation>
    </message>
    <message>
        <source>Half the y size of the start box: the particles start evenly spread in this box; 0 starts them all at the same y.</source>
        <translation>開始点を囲む箱の y 方向の大きさの半分。粒子はこの箱の中に一様に散らばって始まります。0 ではすべて同じ y から始まります。</translation>
    </message>
    <message>
        <source>Half the z size of the start box: the particles start evenly spread in this box; 0 starts them all at the same z.</source>
        <translation>開始点を囲む箱の z 方向の大きさの半分。粒子はこの箱の中に一様に散らばって始まります。0 ではすべて同じ z から始まります。</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis in one iteration: larger values follow faster objects, but spread the particles wider.</source>
        <translation>1 回の反復で粒子が各軸方向にランダムに動く大きさ。大きいほど速い物体を追えますが、粒子は広く散らばります。</translation>
    </message>
    <message>
        <source>How many filter iterations run on each frame.</source>
        <translation>1 フレームごとに実行するフィルターの反復回数。</translation>
    </message>
    <message>
        <source>Number of particles of the filter: more particles track more reliably, but take more time.</source>
        <translation>フィルターが使う粒子の数。多いほど確実に追跡できますが、時間がかかります。</translation>
    </message>
    <message>
        <source>Iterations per frame</source>
        <translation>フレームごとの反復</translation>
    </message>
    <message>
        <source>Motion sigma</source>
        <translation>動きのシグマ</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子数</translation>
    </message>
    <message>
        <source>World x coordinate of the center of the box in which the particles start.</source>
        <translation>粒子が始まる箱の中心の世界座標 x。</translation>
    </message>
    <message>
        <source>World y coordinate of the center of the box in which the particles start.</source>
        <translation>粒子が始まる箱の中心の世界座標 y。</translation>
    </message>
    <message>
        <source>World z coordinate of the center of the box in which the particles start.</source>
        <translation>粒子が始まる箱の中心の世界座標 z。</translation>
    </message>
    <message>
        <source>Acceleration sigma</source>
        <translation>加速度のシグマ</translation>
    </message>
    <message>
        <source>Edge length of the space in which a target may appear: with larger values, a track is created only at a higher likelihood.</source>
        <translation>ターゲットが現れうる空間の一辺の長さ。大きいほど、追跡を始めるのに高い尤度が必要になります。</translation>
    </message>
    <message>
        <source>How long a target still counts as present when no camera can see its expected position.</source>
        <translation>ターゲットがあるはずの場所をどのカメラからも見られないとき、まだそこにあるとみなす時間。</translation>
    </message>
    <message>
        <source>Largest number of particles of each target.</source>
        <translation>各ターゲットが使う粒子の最大数。</translation>
    </message>
    <message>
        <source>How strongly targets accelerate, brake and turn: larger values follow abrupt motion, smaller values bridge gaps better.</source>
        <translation>ターゲットがどれだけ強く加速、減速、方向転換するか。大きいほど急な動きを追え、小さいほど途切れをうまく補えます。</translation>
    </message>
    <message>
        <source>Search size</source>
        <translation>探索範囲の大きさ</translation>
    </message>
    <message>
        <source>Survival time</source>
        <translation>存続時間</translation>
    </message>
    <message>
        <source>Time budget</source>
        <translation>時間の上限</translation>
    </message>
    <message>
        <source>How long one iteration may take. To meet this limit, fewer particles are used and searches are spread over several frames. 0 sets no limit. With a limit, a run depends on the speed of the computer and cannot be repeated exactly.</source>
        <translation>1 回の反復にかけてよい時間です。この上限を守るために粒子を減らし、探索を複数のフレームに分けます。0 は上限なしです。上限があると、実行はコンピューターの速度に左右され、正確には再現できません。</translation>
    </message>
    <message>
        <source>Color adaptation</source>
        <translation>色の追従</translation>
    </message>
    <message>
        <source>Time constant with which a target&apos;s color range follows slow changes of light, in each camera separately and only while the target is clearly visible. 0 keeps the range as it is; 2 is a good value in a room with daylight.</source>
        <translation>ターゲットの色範囲が光のゆっくりした変化に追従する時定数。カメラごとに、ターゲットがはっきり見えている間だけ追従します。0 では範囲は変わりません。自然光の入る部屋では 2 が適しています。</translation>
    </message>
    <message>
        <source>Assumed error of a measured position along each axis: larger values trust the particles more, smaller values the measurement.</source>
        <translation>測定位置の各軸の誤差の想定。大きいほど粒子を、小さいほど測定を信頼します。</translation>
    </message>
    <message>
        <source>Observation sigma</source>
        <translation>観測シグマ</translation>
    </message>
    <message>
        <source>Adaptation</source>
        <translation>適応</translation>
    </message>
    <message>
        <source>Aspect sigma</source>
        <translation>縦横比のシグマ</translation>
    </message>
    <message>
        <source>Min. color share</source>
        <translation>色の最小割合</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis between images, in multiples of the target size, in addition to their constant velocity.</source>
        <translation>画像ごとに、等速の動きに加えて、粒子が各軸方向にランダムに動く大きさ。ターゲットの大きさを単位とします。</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis between images, in addition to their constant velocity: larger values follow sudden motion, but spread the particles wider.</source>
        <translation>画像ごとに、等速の動きに加えて、粒子が各軸方向にランダムに動く大きさ。大きいほど急な動きを追えますが、広く散らばります。</translation>
    </message>
    <message>
        <source>How strongly positions with more of the target&apos;s colors are preferred.</source>
        <translation>ターゲットの色がより多い位置をどれだけ優先するか。</translation>
    </message>
    <message>
        <source>Jump reach</source>
        <translation>飛び先の範囲</translation>
    </message>
    <message>
        <source>Jump share</source>
        <translation>飛び先を試す割合</translation>
    </message>
    <message>
        <source>Likelihood sigma</source>
        <translation>尤度のシグマ</translation>
    </message>
    <message>
        <source>Position sigma</source>
        <translation>位置のシグマ</translation>
    </message>
    <message>
        <source>Scale sigma</source>
        <translation>大きさのシグマ</translation>
    </message>
    <message>
        <source>How much of the box&apos;s current colors is blended into the reference colors after each image; 0 keeps the colors of the first image.</source>
        <translation>画像ごとに、枠の現在の色を基準の色にどれだけ混ぜるか。0 では最初の画像の色のままです。</translation>
    </message>
    <message>
        <source>Share of the particles that jump to other positions at which the target&apos;s colors are found.</source>
        <translation>ターゲットの色が見つかった別の位置へ飛ばす粒子の割合。</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>鋭さ</translation>
    </message>
    <message>
        <source>The target counts as hidden and keeps its position if less than this share of its usual colors is found.</source>
        <translation>ふだんの色のこの割合未満しか見つからないとき、ターゲットは隠れたとみなされ、位置を保ちます。</translation>
    </message>
    <message>
        <source>Time after which a new object that stays in place counts as background.</source>
        <translation>動かずに残る新しい物体を背景とみなすまでの時間。</translation>
    </message>
    <message>
        <source>Half width of the area, x</source>
        <translation>領域の半分 x</translation>
    </message>
    <message>
        <source>Half width of the area, y</source>
        <translation>領域の半分 y</translation>
    </message>
    <message>
        <source>Area x</source>
        <translation>領域 x</translation>
    </message>
    <message>
        <source>Area y</source>
        <translation>領域 y</translation>
    </message>
    <message>
        <source>Background memory</source>
        <translation>背景の記憶</translation>
    </message>
    <message>
        <source>Background model</source>
        <translation>背景モデル</translation>
    </message>
    <message>
        <source>Confirmation time</source>
        <translation>確認時間</translation>
    </message>
    <message>
        <source>Create tracks</source>
        <translation>人物の出現</translation>
    </message>
    <message>
        <source>Body points</source>
        <translation>体の点の数</translation>
    </message>
    <message>
        <source>Color noise</source>
        <translation>色のノイズ</translation>
    </message>
    <message>
        <source>Color weight</source>
        <translation>色の重み</translation>
    </message>
    <message>
        <source>Darkest shadow</source>
        <translation>最も暗い影</translation>
    </message>
    <message>
        <source>Weight per camera</source>
        <translation>カメラごとの重み</translation>
    </message>
    <message>
        <source>Floor z</source>
        <translation>床の z</translation>
    </message>
    <message>
        <source>Assumed height of a person whose height is not known yet.</source>
        <translation>身長がまだ分からない人物に仮定する身長。</translation>
    </message>
    <message>
        <source>Height of the floor in world coordinates.</source>
        <translation>世界座標系での床の高さ。</translation>
    </message>
    <message>
        <source>How long a person still counts as present when fewer than two cameras see the person.</source>
        <translation>2 台未満のカメラにしか写っていない人物を、まだそこにいるとみなす時間。</translation>
    </message>
    <message>
        <source>Number of particles of each person.</source>
        <translation>1 人あたりの粒子の数。</translation>
    </message>
    <message>
        <source>Number of points that represent the volume of each person.</source>
        <translation>各人物の体積を表す点の数。</translation>
    </message>
    <message>
        <source>How much the colors of clothes count compared with the masks when people are close to each other.</source>
        <translation>人が近くにいるとき、マスクに対して服の色をどれだけ重んじるか。</translation>
    </message>
    <message>
        <source>Smallest distance between the centers of two people.</source>
        <translation>2 人の中心の最小距離。</translation>
    </message>
    <message>
        <source>How strongly people accelerate, brake and turn.</source>
        <translation>人がどれだけ強く加速、減速、方向転換するか。</translation>
    </message>
    <message>
        <source>Min. hue likelihood</source>
        <translation>色相の尤度の下限</translation>
    </message>
    <message>
        <source>Hue sigma</source>
        <translation>色相のシグマ</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>Images are reduced to at most this width before they are analyzed; 0 keeps them as they are.</source>
        <translation>画像を解析する前に、最大でもこの幅まで縮小します。0 では縮小しません。</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>学習時間</translation>
    </message>
    <message>
        <source>Minimum distance</source>
        <translation>最小距離</translation>
    </message>
    <message>
        <source>Lower limit of the likelihood of a pixel&apos;s hue (h_B in the paper); above 0 because another object may hide the person.</source>
        <translation>色相の尤度の下限（論文の h_B）。別の物体が人を隠すことがあるため、0 より大きくします。</translation>
    </message>
    <message>
        <source>Lower limit of the likelihood of a pixel&apos;s saturation (s_B in the paper).</source>
        <translation>彩度の尤度の下限（論文の s_B）。</translation>
    </message>
    <message>
        <source>Smallest likelihood where a camera sees no motion (p_B in the paper: 0.2).</source>
        <translation>カメラに動きが写らない所での尤度の下限（論文の p_B：0.2）。</translation>
    </message>
    <message>
        <source>Mask smoothing</source>
        <translation>マスクの平滑化</translation>
    </message>
    <message>
        <source>Min. motion likelihood</source>
        <translation>動きの尤度の下限</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>位置のノイズ</translation>
    </message>
    <message>
        <source>Min. saturation likelihood</source>
        <translation>彩度の尤度の下限</translation>
    </message>
    <message>
        <source>Saturation sigma</source>
        <translation>彩度のシグマ</translation>
    </message>
    <message>
        <source>Sigma of the Gaussian that smooths the motion masks (the paper: 4 px).</source>
        <translation>動きのマスクを平滑化するガウス関数のシグマ（論文では 4 px）。</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each component of the velocity, per frame.</source>
        <translation>1 フレームごとに速度の各成分へ加えるノイズの標準偏差。</translation>
    </message>
    <message>
        <source>Standard deviation of the random motion that is added to each coordinate of a particle, per frame.</source>
        <translation>1 フレームごとに粒子の各座標へ加えるランダムな動きの標準偏差。</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on hue and saturation, per frame.</source>
        <translation>1 フレームごとに色相と彩度へ加えるノイズの標準偏差。</translation>
    </message>
    <message>
        <source>Usual height</source>
        <translation>ふつうの身長</translation>
    </message>
    <message>
        <source>Velocity noise</source>
        <translation>速度のノイズ</translation>
    </message>
    <message>
        <source>Calibration error</source>
        <translation>キャリブレーション誤差</translation>
    </message>
    <message>
        <source>Error of the directions in which the cameras see objects. It is part of the reported uncertainty of a position. 0.25 suits a calibration by hand.</source>
        <translation>カメラが物体を見る方向の誤差。表示される位置の不確かさに含まれます。手動キャリブレーションには 0.25 が適しています。</translation>
    </message>
    <message>
        <source>Time error</source>
        <translation>時刻の誤差</translation>
    </message>
    <message>
        <source>1 tracks every person that several cameras see. 0 tracks only people that you add by hand.</source>
        <translation>1 では、複数のカメラに写った人をすべて追跡します。0 では、手で追加した人物だけを追跡します。</translation>
    </message>
    <message>
        <source>Coordinate of the center of the tracked floor area along this axis.</source>
        <translation>追跡する床面の中心の、この軸に沿った座標。</translation>
    </message>
    <message>
        <source>Error of the times at which the images were taken. It is part of the reported uncertainty of a moving target. 8 suits webcams.</source>
        <translation>画像を撮影した時刻の誤差。動くターゲットの表示される不確かさに含まれます。ウェブカメラには 8 が適しています。</translation>
    </message>
    <message>
        <source>Half the size of the tracked floor area along this axis. A person who crosses the border of the area counts as having left.</source>
        <translation>この軸に沿った、追跡する床の大きさの半分。境界を越えた人は立ち去ったとみなします。</translation>
    </message>
    <message>
        <source>How far the particles may deviate from the distribution that they represent (Kullback-Leibler divergence). A smaller value uses more particles when the cloud is spread out; 0 always uses the largest number.</source>
        <translation>粒子が、それらの表す分布からどれだけ外れてよいか（カルバック・ライブラー情報量）。小さいほど、粒子の雲が広がっているときに多くの粒子を使います。0 では常に最大数を使います。</translation>
    </message>
    <message>
        <source>How far the target may be from its predicted position, in multiples of the target size. Positions that are farther away count as unlikely.</source>
        <translation>ターゲットが予測位置からどれだけ離れてよいか（ターゲットの大きさを単位とする）。これより遠い位置はありそうもないとみなします。</translation>
    </message>
    <message>
        <source>How long a moving region that belongs to no tracked person must be visible before a new track is created.</source>
        <translation>追跡中の誰のものでもない動く領域が見えてから、新しい人物の追跡を始めるまでの時間。</translation>
    </message>
    <message>
        <source>How long the cameras only learn the background at the start. Nobody should be in view during this time.</source>
        <translation>最初に、カメラが背景だけを学習する時間。その間は誰も写らないようにします。</translation>
    </message>
    <message>
        <source>How moving regions are found. 0: one Gaussian for each pixel (fast). 1: MOG2 of OpenCV. 2: KNN of OpenCV.</source>
        <translation>動く領域の見つけ方。0：ピクセルごとに 1 つのガウス分布（高速）。1：OpenCV の MOG2。2：OpenCV の KNN。</translation>
    </message>
    <message>
        <source>How strongly the mask of each camera influences where a person is tracked: larger values rely more on the masks.</source>
        <translation>各カメラのマスクが人物の位置にどれだけ影響するか。大きいほどマスクを信用します。</translation>
    </message>
    <message>
        <source>How much the colors of a particle&apos;s box may differ from the reference colors (Bhattacharyya distance): smaller values trust the best particles more.</source>
        <translation>粒子の枠の色が基準の色からどれだけ違ってよいか（バタチャリヤ距離）。小さいほど最良の粒子を重んじます。</translation>
    </message>
    <message>
        <source>How much the ratio of width to height may change between images, as the standard deviation of its logarithm; 0 keeps the initial ratio.</source>
        <translation>画像ごとに縦横比がどれだけ変わってよいか（対数の標準偏差）。0 では最初の比のままです。</translation>
    </message>
    <message>
        <source>How much the size of the box may change between images, as the standard deviation of its logarithm; 0 keeps the initial size.</source>
        <translation>画像ごとに枠の大きさがどれだけ変わってよいか（対数の標準偏差）。0 では最初の大きさのままです。</translation>
    </message>
    <message>
        <source>Lowest brightness of a shadow, as a share of the background&apos;s brightness at the same hue. Anything darker counts as a moving region.</source>
        <translation>影の最低の明るさ（色相が同じ背景の明るさに対する割合）。これより暗いものは動く領域とみなします。</translation>
    </message>
    <message>
        <source>Smallest number of particles of each target; used when all its particles are close together.</source>
        <translation>各ターゲットの粒子の最小数。すべての粒子が近くに集まっているときに使います。</translation>
    </message>
    <message>
        <source>Standard deviation of a measured hue; hues range from 0 to 1.</source>
        <translation>測った色相の標準偏差。色相は 0 から 1 の値です。</translation>
    </message>
    <message>
        <source>Standard deviation of a measured saturation; saturations range from 0 to 1.</source>
        <translation>測った彩度の標準偏差。彩度は 0 から 1 の値です。</translation>
    </message>
    <message>
        <source>Delay spread</source>
        <translation>遅延のばらつき</translation>
    </message>
    <message>
        <source>How much the delays of the cameras may differ (standard deviation). While a target moves, the delays are estimated and corrected. 0 if all time stamps are exact: then no delay is estimated.</source>
        <translation>カメラの遅延がどれだけ異なりうるか（標準偏差）。ターゲットが動いている間に遅延を推定し、補正します。すべてのタイムスタンプが正確なら 0 にします。その場合、遅延は推定しません。</translation>
    </message>
    <message>
        <source>KLD error</source>
        <translation>KLD誤差</translation>
    </message>
    <message>
        <source>Minimum particles</source>
        <translation>最小粒子数</translation>
    </message>
    <message>
        <source>Start box, center x</source>
        <translation>開始範囲の中心 x</translation>
    </message>
    <message>
        <source>Start box, center y</source>
        <translation>開始範囲の中心 y</translation>
    </message>
    <message>
        <source>Start box, center z</source>
        <translation>開始範囲の中心 z</translation>
    </message>
    <message>
        <source>Start box, half width x</source>
        <translation>開始範囲の半幅 x</translation>
    </message>
    <message>
        <source>Start box, half width y</source>
        <translation>開始範囲の半幅 y</translation>
    </message>
    <message>
        <source>Start box, half width z</source>
        <translation>開始範囲の半幅 z</translation>
    </message>
</context>
<context>
    <name>ParameterGroup</name>
    <message>
        <source>Area and people</source>
        <translation>領域と人物</translation>
    </message>
    <message>
        <source>Essential</source>
        <translation>基本</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>上級</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動き</translation>
    </message>
    <message>
        <source>Search and start</source>
        <translation>探索と開始</translation>
    </message>
</context>
<context>
    <name>ParameterRow</name>
    <message>
        <source>%1
From %2 to %3%4; default %5%4.</source>
        <translation>%1
%2 から %3%4 まで。既定値は %5%4。</translation>
    </message>
    <message>
        <source>%1
From %2 to %3%4; the default comes from the region that the cameras see.</source>
        <translation>%1
%2 から %3%4 まで。既定値はカメラに映る範囲から決まります。</translation>
    </message>
    <message>
        <source>Changed: the default is %1.</source>
        <translation>変更済み：既定値は %1 です。</translation>
    </message>
    <message>
        <source>Reset to %1 (Backspace on the slider)</source>
        <translation>%1 に戻す（スライダー上で Backspace）</translation>
    </message>
</context>
<context>
    <name>People</name>
    <message>
        <source>learning background: %1 % · keep the scene empty</source>
        <translation>背景を学習中：%1 % · 画面に入らないでください</translation>
    </message>
    <message>
        <source>image ignored: %1 % of it is moving</source>
        <translation>画像を使いません：%1 % が動いています</translation>
    </message>
    <message>
        <source>learning: %1 %</source>
        <translation>学習中：%1 %</translation>
    </message>
</context>
<context>
    <name>PlotAxisStrip</name>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>反復</translation>
    </message>
</context>
<context>
    <name>PlotFigure</name>
    <message>
        <source>time, s</source>
        <translation>時間, s</translation>
    </message>
    <message>
        <source>filter iteration</source>
        <translation>フィルター反復</translation>
    </message>
    <message>
        <source>Dewpoint plots</source>
        <translation>Dewpoint のグラフ</translation>
    </message>
</context>
<context>
    <name>PlotQuantity</name>
    <message>
        <source>%1 (%2)</source>
        <comment>title of a plot, unit of its axis</comment>
        <translation>%1（%2）</translation>
    </message>
</context>
<context>
    <name>PlotReadout</name>
    <message>
        <source>truth</source>
        <translation>真値</translation>
    </message>
</context>
<context>
    <name>Quantity</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 フレーム/秒</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>no image</source>
        <translation>画像なし</translation>
    </message>
    <message>
        <source>camera covered or moved</source>
        <translation>カメラが覆われたか動いた</translation>
    </message>
    <message>
        <source>too dark</source>
        <translation>暗すぎる</translation>
    </message>
    <message>
        <source>out of view</source>
        <translation>視野の外</translation>
    </message>
    <message>
        <source>partly hidden</source>
        <translation>一部が隠れている</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隠れている</translation>
    </message>
    <message>
        <source>at a distractor</source>
        <translation>似た物の位置</translation>
    </message>
    <message>
        <source>%1 away from a distractor</source>
        <translation>似た物から %1</translation>
    </message>
    <message>
        <source>no matching color</source>
        <translation>一致する色なし</translation>
    </message>
    <message>
        <source>color found %1 away</source>
        <translation>%1 離れた所に色を検出</translation>
    </message>
    <message>
        <source>right color, wrong shape</source>
        <translation>色は合うが形が違う</translation>
    </message>
    <message>
        <source>hidden here</source>
        <translation>ここでは隠れている</translation>
    </message>
    <message>
        <source>not in this image</source>
        <translation>この画像に写っていない</translation>
    </message>
</context>
<context>
    <name>RunPlots</name>
    <message>
        <source>all cameras</source>
        <translation>全カメラ</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>広がり</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>有効サンプルサイズ</translation>
    </message>
    <message>
        <source>effective</source>
        <translation>有効</translation>
    </message>
    <message>
        <source>particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Log likelihood</source>
        <translation>対数尤度</translation>
    </message>
    <message>
        <source>Existence</source>
        <translation>存在確率</translation>
    </message>
    <message>
        <source>Error against ground truth</source>
        <translation>真の位置との誤差</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Time per step</source>
        <translation>1 ステップの時間</translation>
    </message>
    <message>
        <source>one iteration</source>
        <translation>1 反復</translation>
    </message>
    <message>
        <source>Similarity</source>
        <translation>類似度</translation>
    </message>
    <message>
        <source>similarity to the reference colors</source>
        <translation>基準の色との類似度</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高さ</translation>
    </message>
</context>
<context>
    <name>SizeFitText</name>
    <message>
        <source>same as during calibration</source>
        <translation>キャリブレーション時と同じ</translation>
    </message>
    <message>
        <source>cropped on all sides</source>
        <translation>四辺を切り取ったもの</translation>
    </message>
    <message>
        <source>cropped at the right and at the bottom</source>
        <translation>右と下を切り取ったもの</translation>
    </message>
    <message>
        <source>scaled</source>
        <translation>拡大縮小したもの</translation>
    </message>
    <message>
        <source>rotated clockwise by 90°</source>
        <translation>時計回りに90°回転したもの</translation>
    </message>
    <message>
        <source>rotated clockwise by 270°</source>
        <translation>時計回りに270°回転したもの</translation>
    </message>
</context>
<context>
    <name>TakeText</name>
    <message>
        <source>%1 left</source>
        <translation>残り %1</translation>
    </message>
    <message>
        <source>Recording take %1</source>
        <translation>テイク %1 を録画中</translation>
    </message>
    <message numerus="yes">
        <source>%n dropped image(s)</source>
        <translation>
            <numerusform>欠落画像 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>空き %1</translation>
    </message>
    <message>
        <source>%1: %2 images, %3, %4 dropped, %5</source>
        <translation>%1: %2 枚、%3、欠落 %4 枚、%5</translation>
    </message>
    <message>
        <source>The take contains %1 from before you pressed Record. There was not enough memory for more.</source>
        <translation>テイクは開始前の %1 を含みます。メモリが足りず、それ以上は保持できませんでした。</translation>
    </message>
    <message>
        <source>The take contains %1 from before you pressed Record.</source>
        <translation>テイクは開始前の %1 を含みます。</translation>
    </message>
    <message>
        <source>The run began before the take, so the run cannot be tracked again from its beginning. To avoid this, restart the run while you record.</source>
        <translation>実行はテイクより前に始まったため、最初からもう一度追跡することはできません。これを避けるには、録画中に実行を再開始してください。</translation>
    </message>
    <message>
        <source>Tracking the take gives exactly the results of the live run in all %1 frames.</source>
        <translation>テイクを追跡した結果は、全 %1 フレームでライブ実行の結果と完全に一致します。</translation>
    </message>
    <message>
        <source>%1 of %2 frames differ from the live run, the first one is frame %3. Positions differ by up to %4.</source>
        <translation>%2 フレーム中 %1 フレームがライブ実行と異なります。最初はフレーム %3 です。位置の差は最大 %4 です。</translation>
    </message>
    <message>
        <source>Images of %1 frames were dropped, the first in frame %2.</source>
        <translation>%1 フレームで画像が失われました。最初はフレーム %2 です。</translation>
    </message>
    <message>
        <source>Frames %1 to %2 were tracked with other settings.</source>
        <translation>フレーム %1 から %2 は別の設定で追跡されました。</translation>
    </message>
    <message>
        <source>A time budget is set, so results depend on the speed of the computer.</source>
        <translation>時間予算が設定されているため、結果はコンピューターの速度に左右されます。</translation>
    </message>
    <message>
        <source>The images of %1 are stored with slightly different colors, because the camera sends them uncompressed.</source>
        <translation>カメラが非圧縮で送るため、%1 の画像はわずかに異なる色で保存されています。</translation>
    </message>
</context>
<context>
    <name>TargetPanel</name>
    <message>
        <source>%1, in %2
Center %3, %4, size %5 × %6
Similarity %7
Effective sample size %8 of %9</source>
        <translation>%1（%2）
中心 %3, %4、大きさ %5 × %6
類似度 %7
有効サンプル数 %8 / %9</translation>
    </message>
    <message>
        <source>Spread %1</source>
        <translation>広がり %1</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Frame %1, %2</source>
        <translation>フレーム %1、%2</translation>
    </message>
    <message>
        <source>not tracked</source>
        <translation>未追跡</translation>
    </message>
    <message>
        <source>✕ %1</source>
        <translation>✕ %1</translation>
    </message>
    <message>
        <source>tracking frames %2 to %3 again: now at %1</source>
        <translation>フレーム %2～%3 を再追跡中: 現在 %1</translation>
    </message>
    <message>
        <source>✕ no image</source>
        <translation>✕ 画像なし</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>修正済み</translation>
    </message>
    <message>
        <source>tracked with earlier settings</source>
        <translation>以前の設定で追跡</translation>
    </message>
    <message>
        <source>The state of each target appears here during tracking.</source>
        <translation>追跡中、ここに各ターゲットの状態が表示されます。</translation>
    </message>
</context>
<context>
    <name>TrackingState</name>
    <message>
        <source>○ searching</source>
        <translation>○ 探索中</translation>
    </message>
    <message>
        <source>▲ lost</source>
        <translation>▲ 見失い</translation>
    </message>
    <message>
        <source>✕ missing</source>
        <translation>✕ なし</translation>
    </message>
    <message>
        <source>– no images</source>
        <translation>– 画像なし</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>ターゲットなし</translation>
    </message>
    <message>
        <source>– not tracked</source>
        <translation>– 未追跡</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ 隠れている</translation>
    </message>
    <message>
        <source>– no box</source>
        <translation>– 枠なし</translation>
    </message>
    <message>
        <source>◔ learning background</source>
        <translation>◔ 背景を学習中</translation>
    </message>
    <message>
        <source>◌ nobody in view</source>
        <translation>◌ 誰もいません</translation>
    </message>
    <message>
        <source>– not present</source>
        <translation>– 不在</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ あいまい</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● 追跡中</translation>
    </message>
</context>
<context>
    <name>TransportBar</name>
    <message>
        <source>Toolbar</source>
        <translation>ツールバー</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation>m/s²</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>sizes</source>
        <translation>倍（大きさ）</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
</context>
<context>
    <name>VideoDialog</name>
    <message>
        <source>Frame %1</source>
        <translation>フレーム %1</translation>
    </message>
</context>
<context>
    <name>WandSettings</name>
    <message>
        <source>The ball touches the floor</source>
        <translation>ボールが床に触れている</translation>
    </message>
    <message>
        <source>The ball is at one end of the known distance</source>
        <translation>ボールが既知の距離の一方の端にある</translation>
    </message>
    <message>
        <source>The ball is at the other end of the known distance</source>
        <translation>ボールが既知の距離のもう一方の端にある</translation>
    </message>
    <message>
        <source>First frame of the fall</source>
        <translation>落下の最初のフレーム</translation>
    </message>
    <message>
        <source>Last frame of the fall</source>
        <translation>落下の最後のフレーム</translation>
    </message>
    <message>
        <source>At least two cameras must see the ball.</source>
        <translation>2台以上のカメラがボールを見る必要があります。</translation>
    </message>
    <message>
        <source>The scale comes from a known distance: add the times at which the ball is at each end of this distance.</source>
        <translation>縮尺は既知の距離から求めます。ボールがその距離の両端にある時刻を追加してください。</translation>
    </message>
    <message>
        <source>To use a fall, add two times: the first and the last frame of the fall.</source>
        <translation>落下を使うには、落下の最初のフレームと最後のフレームの 2 つの時刻を追加してください。</translation>
    </message>
    <message>
        <source>Both ends of the wand are the same target: choose another target for one of them.</source>
        <translation>ワンドの両端が同じターゲットです。一方に別のターゲットを選んでください。</translation>
    </message>
    <message>
        <source>Learn the color of the ball first: press “Learn the color” in the toolbar, then click the ball in an image.</source>
        <translation>先にボールの色を学習してください。ツールバーの「色を学習」を押してから、画像でボールをクリックします。</translation>
    </message>
    <message>
        <source>A wand has two balls of different colors: press “Add a target” in the toolbar, then click the second ball in an image.</source>
        <translation>ワンドには色の異なるボールが2つあります。ツールバーの「ターゲットを追加」を押してから、画像で2つ目のボールをクリックしてください。</translation>
    </message>
    <message>
        <source>Also move the ball to the left part of the image of %1.</source>
        <translation>ボールを %1 の画像の左側にも動かしてください。</translation>
    </message>
    <message>
        <source>Also move the ball to the right part of the image of %1.</source>
        <translation>ボールを %1 の画像の右側にも動かしてください。</translation>
    </message>
    <message>
        <source>Also move the ball to the upper part of the image of %1.</source>
        <translation>ボールを %1 の画像の上側にも動かしてください。</translation>
    </message>
    <message>
        <source>Also move the ball to the lower part of the image of %1.</source>
        <translation>ボールを %1 の画像の下側にも動かしてください。</translation>
    </message>
    <message>
        <source>Also move the ball to all edges of the image of %1.</source>
        <translation>ボールを %1 の画像のすべての端にも動かしてください。</translation>
    </message>
    <message>
        <source>The ball was seen for only %1. Wave for half a minute.</source>
        <translation>ボールが見えたのは %1 だけです。30 秒ほど振ってください。</translation>
    </message>
    <message>
        <source>The ball moved only along one line. Move it in all directions: to the sides, up and down, near and far.</source>
        <translation>ボールは 1 本の線に沿ってしか動いていません。左右、上下、手前と奥のすべての方向に動かしてください。</translation>
    </message>
    <message>
        <source>The ball moved only within a plane (%1 thick). Also move it across this plane: toward %2 and away from it.</source>
        <translation>ボールは 1 つの平面（厚さ %1）の中でしか動いていません。この平面を横切る方向、つまり %2 に近づけたり遠ざけたりする方向にも動かしてください。</translation>
    </message>
    <message>
        <source>The distance from %1 to the ball hardly changed (by only %2). Also move the ball toward %1 and away from it.</source>
        <translation>%1 からボールまでの距離はほとんど変わりませんでした（変化はわずか %2）。ボールを %1 に近づけたり遠ざけたりもしてください。</translation>
    </message>
    <message>
        <source>The ball stayed in %1 of the volume that the cameras see together. Move it through the whole volume in which you will track.</source>
        <translation>ボールは、カメラが共通して見る空間の %1 にしかありませんでした。追跡する空間全体で動かしてください。</translation>
    </message>
    <message>
        <source>%1 saw the ball in only %2 of its image.</source>
        <translation>%1 では、画像の %2 にしかボールが写っていません。</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %2 saw the ball at the same time in only %n frame(s). Move the ball where both cameras see it.</source>
        <translation>
            <numerusform>%1 と %2 が同時にボールを見たのは %n フレームだけです。両方のカメラから見える場所でボールを動かしてください。</numerusform>
        </translation>
    </message>
    <message>
        <source>The cameras were calibrated before, and the motion in this recording is not enough to improve that calibration. Keep the previous calibration.</source>
        <translation>カメラはすでにキャリブレーションされており、この記録の動きではそのキャリブレーションを改善できません。以前のキャリブレーションを使ってください。</translation>
    </message>
    <message>
        <source>The old camera positions are known more accurately (±%1) than the new ones (±%2). Keep the old positions.</source>
        <translation>以前のカメラ位置（±%1）は、新しい位置（±%2）より正確にわかっています。以前の位置を使ってください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AboutDialog</name>
    <message>
        <source>Show license</source>
        <translation>ライセンスを表示</translation>
    </message>
    <message>
        <source>Hide license</source>
        <translation>ライセンスを隠す</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Dewpoint について</translation>
    </message>
    <message>
        <source>Dewpoint %1</source>
        <translation>Dewpoint %1</translation>
    </message>
    <message>
        <source>Tracks colored objects in 3D, live, from ordinary cameras with particle filters.</source>
        <translation>普通のカメラと粒子フィルターで、色の付いた物体を 3D でリアルタイムに追跡します。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later (GPL-3.0-or-later), without any warranty.</source>
        <translation>GNU General Public License バージョン 3 以降 (GPL-3.0-or-later) によるフリーソフトウェアです。いかなる保証もありません。</translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation>引用方法</translation>
    </message>
    <message>
        <source>Show or hide the full text of the license</source>
        <translation>ライセンスの全文を表示または非表示にします</translation>
    </message>
    <message>
        <source>Copy citation</source>
        <translation>引用をコピー</translation>
    </message>
    <message>
        <source>Copy the entry for your reference list</source>
        <translation>参考文献リスト用の記載をコピーします</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddPersonTool</name>
    <message>
        <source>Click the person</source>
        <translation>人物をクリック</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter adds a person there</source>
        <translation>%1 の画像：矢印キーで十字を動かし、Enter でそこに人物を追加します</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddressForm</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>試す</translation>
    </message>
    <message>
        <source>Add a camera with this address to the project</source>
        <translation>このアドレスのカメラをプロジェクトに追加します</translation>
    </message>
    <message>
        <source>Make this address the image source of the selected camera</source>
        <translation>このアドレスを選択したカメラの画像ソースにします</translation>
    </message>
    <message>
        <source>Waiting for the first image…</source>
        <translation>最初の画像を待っています…</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>✓ %1</source>
        <translation>✓ %1</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>RTSP camera</source>
        <translation>RTSP カメラ</translation>
    </message>
    <message>
        <source>MJPEG over HTTP</source>
        <translation>HTTP 経由の MJPEG</translation>
    </message>
    <message>
        <source>RTP over UDP</source>
        <translation>UDP 経由の RTP</translation>
    </message>
    <message>
        <source>SRT</source>
        <translation>SRT</translation>
    </message>
    <message>
        <source>GStreamer pipeline</source>
        <translation>GStreamer パイプライン</translation>
    </message>
    <message>
        <source>Test pattern</source>
        <translation>テストパターン</translation>
    </message>
    <message>
        <source>Kind of address</source>
        <translation>アドレスの種類</translation>
    </message>
    <message>
        <source>Shows what an address of this kind looks like</source>
        <translation>この種類のアドレスの書き方を示します</translation>
    </message>
    <message>
        <source>Address of the camera</source>
        <translation>カメラのアドレス</translation>
    </message>
    <message>
        <source>Address of a network camera, a GStreamer pipeline or a test pattern</source>
        <translation>ネットワークカメラのアドレス、GStreamer パイプライン、またはテストパターン</translation>
    </message>
    <message>
        <source>Open the address, and show the first image, its size and the frame rate</source>
        <translation>アドレスを開き、最初の画像、サイズ、フレームレートを表示します</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Assign to selected camera</source>
        <translation>選択したカメラに割り当て</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackgroundImageTaker</name>
    <message>
        <source>“%1” is visible in this image and would become part of the background. Choose a frame without this target.</source>
        <translation>この画像には「%1」が写っていて、背景の一部になってしまいます。このターゲットが写っていないフレームを選んでください。</translation>
    </message>
    <message>
        <source>Use image anyway</source>
        <translation>それでも画像を使う</translation>
    </message>
    <message>
        <source>The image was saved as %1, but is not used, because the settings of the camera were changed in the meantime.</source>
        <translation>画像は %1 として保存しましたが、その間にカメラの設定が変更されたため、使用しません。</translation>
    </message>
    <message>
        <source>Change background image</source>
        <translation>背景画像を変更</translation>
    </message>
    <message>
        <source>The current image is now the background image of %1. It was saved as %2.</source>
        <translation>現在の画像を %1 の背景画像にしました。%2 に保存しました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackwardTracker</name>
    <message>
        <source>Correct position</source>
        <translation>位置を修正</translation>
    </message>
    <message>
        <source>The target was tracked backward to frame %1. It is now being tracked forward again from this frame.</source>
        <translation>ターゲットをフレーム %1 までさかのぼって追跡しました。このフレームから先へ追跡し直しています。</translation>
    </message>
    <message>
        <source>Tracking the target backward: frame %1.</source>
        <translation>ターゲットをさかのぼって追跡しています: フレーム%1。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BirdsEyeView</name>
    <message>
        <source>Bird&apos;s-eye view</source>
        <translation>鳥瞰図</translation>
    </message>
    <message>
        <source>The room in 3D: cameras, particles, estimates and their tracks</source>
        <translation>部屋の 3D 表示：カメラ、粒子、推定位置とその軌跡</translation>
    </message>
    <message>
        <source>3D view not available: %1</source>
        <translation>3D 表示なし：%1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrationPage</name>
    <message>
        <source>Board</source>
        <translation>ボード</translation>
    </message>
    <message>
        <source>Values to calibrate</source>
        <translation>求める値</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>キャリブレーション</translation>
    </message>
    <message>
        <source>Find the board in the recording and calibrate the cameras with it (one undo step)</source>
        <translation>録画からボードを探し、カメラをキャリブレーションします（1 回で元に戻せます）</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop and keep the previous calibration</source>
        <translation>中止し、以前のキャリブレーションを保ちます</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Use the calibration in the project (one undo step)</source>
        <translation>キャリブレーションをプロジェクトで使います（1 回で元に戻せます）</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>レポート…</translation>
    </message>
    <message>
        <source>Save a page with the residuals, coverage and errors of all images, and open it</source>
        <translation>残差、カバー範囲、全画像の誤差のページを保存して開きます</translation>
    </message>
    <message>
        <source>Calibration progress</source>
        <translation>キャリブレーションの進み具合</translation>
    </message>
    <message>
        <source>Show a printed board to the cameras. This page says what to show next. A view is captured when you hold the board still.</source>
        <translation>印刷したボードをカメラに見せてください。次に何を見せるかがこのページに示されます。ボードを静止させるとビューが取り込まれます。</translation>
    </message>
    <message>
        <source>To calibrate from a recording, record a printed board that you hold still in many positions, some of them close to the camera or tilted.</source>
        <translation>録画からキャリブレーションするには、印刷したボードを多くの位置で、近づけたり傾けたりして静止させながら録画します。</translation>
    </message>
    <message>
        <source>Live cameras</source>
        <translation>ライブカメラ</translation>
    </message>
    <message>
        <source>This recording</source>
        <translation>この録画</translation>
    </message>
    <message>
        <source>✓ The cameras are calibrated (Ctrl+Z undoes this).</source>
        <translation>✓ カメラをキャリブレーションしました（Ctrl+Z で元に戻せます）。</translation>
    </message>
    <message>
        <source>Looking for the board: %p %</source>
        <translation>ボードを探しています: %p %</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>レポートを保存</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>ページ (*.html)</translation>
    </message>
    <message>
        <source>Use calibration anyway</source>
        <translation>それでもキャリブレーションを使う</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Find board</source>
        <translation>ボードを検出</translation>
    </message>
    <message>
        <source>Use this board</source>
        <translation>このボードを使う</translation>
    </message>
    <message>
        <source>Search all frames</source>
        <translation>すべてのフレームを検索</translation>
    </message>
    <message>
        <source>Find out from the images which kind of board they show, how many squares it has, and its dictionary. The images do not show how large the squares are: measure this yourself</source>
        <translation>画像から、ボードの種類、マス目の数、辞書を調べます。マス目の大きさは画像からは分からないので、ご自分で測ってください</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>計算中</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show the board that you described.</source>
        <translation>調べた%2枚の画像のうち%1枚に、設定どおりのボードが写っています。</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>画像を左右反転</translation>
    </message>
    <message>
        <source>Saved %1: the board is larger than the paper. Page 1 shows how to put its %2 sheets together.</source>
        <translation>%1を保存しました。ボードは用紙より大きいため、%2枚の用紙のつなぎ方を1ページ目に示しています。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrator</name>
    <message>
        <source>Stopped. The previous calibration is kept.</source>
        <translation>中止しました。以前のキャリブレーションはそのままです。</translation>
    </message>
    <message>
        <source>The cameras of the project have changed: calibrate again.</source>
        <translation>プロジェクトのカメラが変わりました。もう一度キャリブレーションしてください。</translation>
    </message>
    <message>
        <source>Calibrate with a board</source>
        <translation>ボードでキャリブレーション</translation>
    </message>
    <message>
        <source>No board was found. Show the whole board in focus and in even light, then press Find board again.</source>
        <translation>ボードが見つかりませんでした。ボード全体を、ピントを合わせて均一な照明で写し、もう一度「ボードを検出」を押してください。</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>画像を左右反転</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardFloor</name>
    <message>
        <source>Looking for the board in the images shown…</source>
        <translation>表示中の画像でボードを検出しています…</translation>
    </message>
    <message>
        <source>No camera sees the board well enough: %1. Show images in which the board lies on the floor, or correct the description of the board on the page Board.</source>
        <translation>ボードが十分に見えるカメラがありません: %1。ボードが床に置かれている画像を表示するか、「ボード」ページでボードの説明を直してください。</translation>
    </message>
    <message>
        <source>The floor was not set, because the cameras have changed in the meantime. Try again.</source>
        <translation>その間にカメラが変更されたため、床は設定されませんでした。もう一度試してください。</translation>
    </message>
    <message>
        <source>Set the floor from the board</source>
        <translation>ボードから床を設定</translation>
    </message>
    <message numerus="yes">
        <source>The floor is set from the board, which %n camera(s) can see (error %1). The world was rotated by %2.</source>
        <translation>
            <numerusform>ボードから床を設定しました（%n 台のカメラに写っています、誤差 %1）。ワールドは %2 回転しました。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardForm</name>
    <message>
        <source>Print the board</source>
        <translation>ボードを印刷</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>チェスボード</translation>
    </message>
    <message>
        <source>ChArUco (with markers)</source>
        <translation>ChArUco（マーカー付き）</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>ボードの種類</translation>
    </message>
    <message>
        <source>Squares per row and column</source>
        <translation>マス目の数（横・縦）</translation>
    </message>
    <message>
        <source>Squares in a row</source>
        <translation>横のマス目の数</translation>
    </message>
    <message>
        <source>Number of squares in a row, black and white together</source>
        <translation>1 行のマス目の数（黒と白の合計）</translation>
    </message>
    <message>
        <source>Squares in a column</source>
        <translation>縦のマス目の数</translation>
    </message>
    <message>
        <source>Number of squares in a column, black and white together</source>
        <translation>1 列のマス目の数（黒と白の合計）</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>マス目の一辺</translation>
    </message>
    <message>
        <source>Unit of the sizes</source>
        <translation>寸法の単位</translation>
    </message>
    <message>
        <source>Unit of the sizes that you enter</source>
        <translation>寸法を入力する単位</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>マーカーの一辺</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>マーカーの辞書</translation>
    </message>
    <message>
        <source>The marker dictionary that was chosen when the board was made</source>
        <translation>ボードを作ったときに選んだマーカーの辞書</translation>
    </message>
    <message>
        <source>Legacy ChArUco layout</source>
        <translation>旧形式の ChArUco</translation>
    </message>
    <message>
        <source>Inverted colors</source>
        <translation>白黒反転</translation>
    </message>
    <message>
        <source>White markers and corners on a black page</source>
        <translation>黒い紙に白いマーカーと角</translation>
    </message>
    <message>
        <source>Print this board…</source>
        <translation>このボードを印刷…</translation>
    </message>
    <message>
        <source>Save the board as a PDF at its true size, with a scale bar to check with a ruler</source>
        <translation>ボードを実寸の PDF に保存します。定規で確かめる目盛りが付きます</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>%1 × %2 inner corners. Description for the command line:</source>
        <translation>内側の角 %1 × %2。コマンドライン用の記述:</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>辞書</translation>
    </message>
    <message>
        <source>A ChArUco board may be partly hidden, or partly outside the image; a chessboard must be completely visible</source>
        <translation>ChArUcoボードは一部が隠れていても、一部が画像の外に出ていてもかまいません。チェスボードは全体が見える必要があります</translation>
    </message>
    <message>
        <source>Measure a long row on the print with a ruler, and divide its length by the number of its squares</source>
        <translation>印刷物の長い行を定規で測り、その長さを行のマス目の数で割ります</translation>
    </message>
    <message>
        <source>Length of one side of a marker, with its black border</source>
        <translation>マーカーの一辺の長さ（黒い縁を含む）</translation>
    </message>
    <message>
        <source>For ChArUco boards with an even number of rows that were made with software older than OpenCV 4.6: their first square is white</source>
        <translation>OpenCV 4.6 より古いソフトウェアで作った、行数が偶数の ChArUco ボード用です。最初のマス目が白です</translation>
    </message>
    <message>
        <source>Size of the paper. A larger board is split over several sheets</source>
        <translation>用紙の大きさ。用紙より大きいボードは複数の用紙に分割されます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardGoalForm</name>
    <message>
        <source>Find</source>
        <translation>求めるもの</translation>
    </message>
    <message>
        <source>Intrinsics and positions</source>
        <translation>内部パラメータと位置</translation>
    </message>
    <message>
        <source>Intrinsics</source>
        <translation>内部パラメータ</translation>
    </message>
    <message>
        <source>Camera positions</source>
        <translation>カメラの位置</translation>
    </message>
    <message>
        <source>Values to calibrate</source>
        <translation>求める値</translation>
    </message>
    <message>
        <source>Intrinsics: lens and sensor, for each camera separately. Positions: where the cameras are, computed from a board that several cameras see at the same time</source>
        <translation>内部パラメータ: 各カメラのレンズとセンサー。位置: 複数のカメラが同時に見るボードから計算した、カメラの場所</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>レンズモデル</translation>
    </message>
    <message>
        <source>Pinhole, 5 coefficients</source>
        <translation>ピンホール、係数5個</translation>
    </message>
    <message>
        <source>Pinhole, 8 coefficients (wide)</source>
        <translation>ピンホール、係数8個（広角）</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>魚眼</translation>
    </message>
    <message>
        <source>Frame with the board on the floor</source>
        <translation>ボードが床に置かれているフレーム</translation>
    </message>
    <message>
        <source>Number of the frame with the board on the floor</source>
        <translation>ボードが床にあるフレーム</translation>
    </message>
    <message>
        <source>Set to current frame</source>
        <translation>現在のフレーム</translation>
    </message>
    <message>
        <source>Set floor frame to current frame</source>
        <translation>現在のフレームを床に使う</translation>
    </message>
    <message>
        <source>Enter the number of the frame that is shown now</source>
        <translation>今表示しているフレームの番号を入力します</translation>
    </message>
    <message>
        <source>Accuracy goal</source>
        <translation>目標とする精度</translation>
    </message>
    <message>
        <source>Desired accuracy of the intrinsics</source>
        <translation>内部パラメータの目標精度</translation>
    </message>
    <message>
        <source>Guidance ends when the intrinsics are this accurate in all parts of the image</source>
        <translation>内部パラメータが画像全体でこの精度になると案内が終わります</translation>
    </message>
    <message>
        <source>Desired accuracy of the positions</source>
        <translation>位置の目標精度</translation>
    </message>
    <message>
        <source>Guidance ends when the position of each camera is this accurate</source>
        <translation>各カメラの位置がこの精度になると案内が終わります</translation>
    </message>
    <message>
        <source>5 coefficients for most lenses, 8 for wide-angle lenses, fisheye for a field of view above about 120°</source>
        <translation>ほとんどのレンズは係数 5 個、広角レンズは 8 個、視野角が約 120° を超える場合は魚眼</translation>
    </message>
    <message>
        <source>The board as it lies in this video frame defines the world coordinates: X along its rows, Y toward its upper edge, Z up from the floor. Without such a frame, the first camera keeps its position</source>
        <translation>この動画フレームで床に置かれたボードが世界座標を決めます。X はボードの行の向き、Y はボードの上の辺の向き、Z は床から上。そのようなフレームがなければ、最初のカメラの位置を保ちます</translation>
    </message>
    <message>
        <source>Number of the frame, as in the timeline (the first frame is 1)</source>
        <translation>タイムラインと同じフレーム番号(最初のフレームは1)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardLive</name>
    <message>
        <source>Time for which the board was held still in front of %1</source>
        <translation>%1の前でボードを静止させた時間</translation>
    </message>
    <message>
        <source>Positions in which %1 saw the board</source>
        <translation>%1がボードを見た場所</translation>
    </message>
    <message>
        <source>Filled: image regions and tilts in which the board was already shown. Orange: what to show next. Green: the board in the current image</source>
        <translation>塗り: ボードを見せた領域と傾き。オレンジ: 次に見せるもの。緑: 現在の画像のボード</translation>
    </message>
    <message>
        <source>Capture now</source>
        <translation>今取り込む</translation>
    </message>
    <message>
        <source>Capture the board as it is shown now, even if it is not held still</source>
        <translation>静止していなくても、今見せているボードを取り込みます</translation>
    </message>
    <message>
        <source>Set floor from board</source>
        <translation>ボードで床を設定</translation>
    </message>
    <message>
        <source>Next: positions</source>
        <translation>次へ: 位置</translation>
    </message>
    <message>
        <source>Accept the current accuracy of the intrinsics; then show the board to several cameras at once</source>
        <translation>内部パラメータは今の精度でよいことにして、次にボードを複数のカメラに同時に見せます</translation>
    </message>
    <message>
        <source>Calibrate with these views</source>
        <translation>これらのビューでキャリブレーション</translation>
    </message>
    <message>
        <source>Finish now with the views captured so far</source>
        <translation>これまでに取り込んだビューで終わります</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Find the board in the live images and get guidance on what to show</source>
        <translation>ライブ画像でボードを探し、何を見せるかを案内します</translation>
    </message>
    <message>
        <source>Waiting for images. Check that the cameras are running.</source>
        <translation>画像を待っています。カメラが動作していることを確かめてください。</translation>
    </message>
    <message>
        <source>Show the board to one camera after the other, following the instructions for each.</source>
        <translation>各カメラの案内に従って、順番にボードを見せてください。</translation>
    </message>
    <message>
        <source>Large display…</source>
        <translation>大きく表示…</translation>
    </message>
    <message>
        <source>Show what to do next in large letters that can be read from across the room, with a sound for each captured view</source>
        <translation>次にすることを部屋の向こうからでも読める大きな文字で表示し、ビューを取得するたびに音を鳴らします</translation>
    </message>
    <message>
        <source>Define the world coordinates with the board that lies on the floor now: X along its rows, Y toward its upper edge, Z up from the floor</source>
        <translation>今床に置かれているボードで世界座標を決めます。X はボードの行の向き、Y はボードの上の辺の向き、Z は床から上</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxExportDialog</name>
    <message>
        <source>Export boxes</source>
        <translation>枠を書き出す</translation>
    </message>
    <message>
        <source>First lines of boxes.csv</source>
        <translation>boxes.csv の最初の行</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Folder for both files; it is created if it does not exist</source>
        <translation>両方のファイルをこのフォルダーに保存します。なければ作成します</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the folder of the files</source>
        <translation>ファイルのフォルダーを選ぶ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Write both files (Enter)</source>
        <translation>両方のファイルを書き出す（Enter）</translation>
    </message>
    <message>
        <source>Folder of the boxes</source>
        <translation>枠のフォルダー</translation>
    </message>
    <message>
        <source>Saved boxes.csv and boxes_mot.txt in %1.</source>
        <translation>boxes.csv と boxes_mot.txt を %1 に保存しました。</translation>
    </message>
    <message>
        <source>The folder already contains exported boxes. Replace them?</source>
        <translation>このフォルダーには書き出した枠がすでにあります。置き換えますか？</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 はすでに存在するため、何も書き込みませんでした。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>Two files are written. In boxes.csv, each row has the box of one target in one frame, its center, its similarity, and whether the target was seen or hidden. The file boxes_mot.txt has the format of the MOT challenge. All lengths are in pixels.</source>
        <translation>2 つのファイルを書き出します。boxes.csv の各行は、1 フレームの 1 ターゲットの枠、中心、類似度、見えているか隠れているかです。boxes_mot.txt は MOT Challenge の形式です。長さの単位はすべてピクセルです。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxModel</name>
    <message>
        <source>◌ hidden</source>
        <translation>◌ 隠れている</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>時間, s</translation>
    </message>
    <message>
        <source>Time of the frame, in seconds</source>
        <translation>フレームの時刻（秒）</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>1 から数えたフレーム番号</translation>
    </message>
    <message>
        <source>target</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>対象の名前</translation>
    </message>
    <message>
        <source>x, px</source>
        <translation>x, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the left edge of the image</source>
        <translation>枠の中心、画像の左端からのピクセル数</translation>
    </message>
    <message>
        <source>y, px</source>
        <translation>y, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the upper edge of the image</source>
        <translation>枠の中心、画像の上端からのピクセル数</translation>
    </message>
    <message>
        <source>width, px</source>
        <translation>幅, px</translation>
    </message>
    <message>
        <source>Box width (pixels)</source>
        <translation>枠の幅、ピクセル</translation>
    </message>
    <message>
        <source>height, px</source>
        <translation>高さ, px</translation>
    </message>
    <message>
        <source>Box height (pixels)</source>
        <translation>枠の高さ、ピクセル</translation>
    </message>
    <message>
        <source>similarity</source>
        <translation>類似度</translation>
    </message>
    <message>
        <source>Similarity of the colors in the box to the initial colors, 0 to 1</source>
        <translation>枠の中の色と最初の色の類似度（0〜1）</translation>
    </message>
    <message>
        <source>spread, px</source>
        <translation>広がり, px</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Hidden: the target was not found in this frame; the box shows where it is expected</source>
        <translation>隠れている：このフレームではターゲットが見つからず、枠は予想される位置を示します</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● 追跡中</translation>
    </message>
    <message>
        <source>Root mean square distance of the particles from their mean</source>
        <translation>粒子とその平均との距離の二乗平均平方根</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPanel</name>
    <message>
        <source>Boxes of the targets</source>
        <translation>ターゲットの枠</translation>
    </message>
    <message>
        <source>This method tracks boxes in images. Click the object or drag a box around it in any camera view. Its box in each frame appears here, in pixels.</source>
        <translation>この手法は画像の中の枠を追跡します。どれかのカメラ画像で物体をクリックするか、枠で囲んでください。各フレームでの枠がピクセル単位でここに表示されます。</translation>
    </message>
    <message numerus="yes">
        <source>%n boxes (coordinates in image pixels)</source>
        <translation>
            <numerusform>%n 個の枠（座標は画像のピクセル単位）</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPicker</name>
    <message>
        <source>No box can be set here, because this camera shows no image.</source>
        <translation>このカメラには画像が表示されていないため、枠を設定できません。</translation>
    </message>
    <message>
        <source>Box of %1</source>
        <translation>%1 の枠</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationChoice</name>
    <message>
        <source>Calibration file:</source>
        <translation>キャリブレーションファイル:</translation>
    </message>
    <message>
        <source>A calibration file of Dewpoint or another program. Cameras are matched by name, or by order if the names differ</source>
        <translation>Dewpoint または他のプログラムのキャリブレーションファイル。カメラは名前で対応づけ、名前が違えば順番で対応づけます</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Continue without a calibration file</source>
        <translation>キャリブレーションファイルを使いません</translation>
    </message>
    <message>
        <source>Recognized: %1. The file does not contain everything: %2. Create the project without this file, then choose Calibration › Import calibration and enter what is missing.</source>
        <translation>判別: %1。ファイルに足りない情報があります: %2。このファイルなしでプロジェクトを作成し、その後「キャリブレーション › キャリブレーションをインポート」で足りない情報を入力してください。</translation>
    </message>
    <message>
        <source>Recognized: %1. It cannot be used: %2.</source>
        <translation>判別: %1。使用できません: %2。</translation>
    </message>
    <message>
        <source>The file cannot be used: %1.</source>
        <translation>このファイルは使用できません: %1。</translation>
    </message>
    <message>
        <source>Not recognized. Dewpoint reads: %1.</source>
        <translation>判別できません。Dewpoint が読める形式: %1。</translation>
    </message>
    <message>
        <source>Recognized: %1. The cameras in the file do not match the cameras above: %2.</source>
        <translation>判別: %1。ファイルのカメラが上のカメラと合いません: %2。</translation>
    </message>
    <message numerus="yes">
        <source>✓ Recognized: %1, %n cameras</source>
        <translation>
            <numerusform>✓ 判別: %1、カメラ %n 台</numerusform>
        </translation>
    </message>
    <message>
        <source>None: the camera positions will only be guesses</source>
        <translation>なし: カメラ位置は推測になります</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>読み込み中…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>キャリブレーションをインポート…</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>キャリブレーションをインポート</translation>
    </message>
    <message>
        <source>%1 (found beside the recordings)</source>
        <translation>%1（録画と同じフォルダーで検出）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationDock</name>
    <message>
        <source>Pages of the camera calibration</source>
        <translation>カメラのキャリブレーションのページ</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationExportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選択</translation>
    </message>
    <message>
        <source>Export the calibration</source>
        <translation>キャリブレーションをエクスポート</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Write the file; an existing file is replaced</source>
        <translation>ファイルを書き出す。既存のものは置き換えられます</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>The program that will read the file</source>
        <translation>ファイルを読むプログラム</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Unit of lengths, if the format does not define it</source>
        <translation>長さの単位。形式が定めていない場合</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>%1 exists and will be replaced.</source>
        <translation>%1 は既にあり、置き換えられます。</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>%1: with the exported calibration, projected points move by at most %2, because the format cannot store this lens model and the lens was fitted again</source>
        <translation>%1: 書き出したキャリブレーションでは、投影した点が最大 %2 ずれます。この形式ではこのレンズモデルを保存できないため、レンズを当てはめ直しました</translation>
    </message>
    <message>
        <source>%1: with the exported calibration, projected points move by at most %2</source>
        <translation>%1: 書き出したキャリブレーションでは、投影した点が最大 %2 ずれます</translation>
    </message>
    <message>
        <source>%1: with the exported lens, %2 of 81 tested directions can no longer be projected into the image</source>
        <translation>%1: 書き出したレンズでは、調べた 81 方向のうち %2 方向を画像に投影できなくなりました</translation>
    </message>
    <message>
        <source>default of the format</source>
        <translation>形式の標準</translation>
    </message>
    <message>
        <source>No accuracy is lost: points are projected to the same pixels as before.</source>
        <translation>精度は失われません。点はこれまでと同じピクセルに投影されます。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationFit</name>
    <message>
        <source>Change since the calibration:</source>
        <translation>キャリブレーション後の変更:</translation>
    </message>
    <message>
        <source>How the images differ from those of the calibration, if they have another size</source>
        <translation>画像の大きさが異なる場合、キャリブレーションの画像とどう違うか</translation>
    </message>
    <message>
        <source>Change of the images since the calibration</source>
        <translation>キャリブレーション後の画像の変更</translation>
    </message>
    <message>
        <source>For each camera of the project, choose a camera of the file:</source>
        <translation>プロジェクトの各カメラに対応するファイルのカメラを選んでください:</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationImportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選択</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>キャリブレーションをインポート</translation>
    </message>
    <message>
        <source>match by name</source>
        <translation>名前で対応付ける</translation>
    </message>
    <message>
        <source>import only for %1</source>
        <translation>%1 だけにインポート</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>フォルダー…</translation>
    </message>
    <message>
        <source>Choose a folder with one file per camera</source>
        <translation>カメラごとのファイルがあるフォルダーを選択</translation>
    </message>
    <message>
        <source>Use the calibration in the project; you can undo this</source>
        <translation>キャリブレーションをプロジェクトで使います。元に戻せます</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>ファイルのとおり</translation>
    </message>
    <message>
        <source>detect automatically</source>
        <translation>自動判別</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>フィート</translation>
    </message>
    <message>
        <source>k1 k2 p1 p2 (pinhole)</source>
        <translation>k1 k2 p1 p2（ピンホール）</translation>
    </message>
    <message>
        <source>k1 k2 k3 k4 (fisheye)</source>
        <translation>k1 k2 k3 k4（魚眼）</translation>
    </message>
    <message>
        <source>from world to camera</source>
        <translation>世界からカメラへ</translation>
    </message>
    <message>
        <source>from camera to world</source>
        <translation>カメラから世界へ</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>The program that wrote the file</source>
        <translation>ファイルを書いたプログラム</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Unit of the lengths in the file; or enter the length of one unit in meters, such as 0.025 for squares of 25 mm</source>
        <translation>ファイル内の長さの単位。または1単位の長さをメートルで入力（25 mm のマス目なら 0.025）</translation>
    </message>
    <message>
        <source>Meaning of the four lens coefficients</source>
        <translation>4つのレンズ係数の意味</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>画像の大きさ</translation>
    </message>
    <message>
        <source>Width and height in pixels, such as 1280x720</source>
        <translation>幅と高さ（ピクセル）。例 1280x720</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>Direction of the transformation that the file stores as a pose</source>
        <translation>ファイルが姿勢として記録する変換の向き</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Project camera that gets the calibration, if the file contains only one camera</source>
        <translation>ファイルにカメラが 1 台分しかない場合に、そのキャリブレーションを使うプロジェクトのカメラ</translation>
    </message>
    <message>
        <source>The file lacks a required value. Set “%1” above.</source>
        <translation>ファイルの情報が足りません。上の「%1」を設定してください。</translation>
    </message>
    <message>
        <source>The calibration uses other camera names. The cameras were matched by order.</source>
        <translation>キャリブレーションのカメラ名が異なるため、順番で対応づけました。</translation>
    </message>
    <message>
        <source>%1 (in the file: %2): moves by %3 and rotates by %4</source>
        <translation>%1（ファイルでは %2）: 移動 %3、回転 %4</translation>
    </message>
    <message>
        <source>Import calibration</source>
        <translation>キャリブレーションをインポート</translation>
    </message>
    <message>
        <source>The cameras now use the calibration from %1.</source>
        <translation>カメラは %1 のキャリブレーションを使います。</translation>
    </message>
    <message>
        <source>match automatically</source>
        <translation>自動で対応付ける</translation>
    </message>
    <message>
        <source>Project images</source>
        <translation>プロジェクトの画像</translation>
    </message>
    <message>
        <source>Names in the file</source>
        <translation>ファイル内の名前</translation>
    </message>
    <message>
        <source>The calibration does not fit the project. Set “%1” above.</source>
        <translation>キャリブレーションがプロジェクトに合いません。上の「%1」を設定してください。</translation>
    </message>
    <message>
        <source>Probably a mistake: %1</source>
        <translation>おそらく誤りです: %1</translation>
    </message>
    <message>
        <source>For each camera of the project, choose the camera in the file from which it gets its calibration</source>
        <translation>プロジェクトの各カメラについて、どのカメラのキャリブレーションをファイルから使うかを選びます</translation>
    </message>
    <message>
        <source>How the images of the project differ from those of the calibration, if they have another size</source>
        <translation>プロジェクトの画像のサイズが異なる場合に、キャリブレーション時の画像とどう違うか</translation>
    </message>
    <message>
        <source>The file contains no pose. Only the intrinsics are imported; the camera keeps its current pose.</source>
        <translation>ファイルに位置姿勢が含まれていません。内部パラメータだけを読み込み、カメラの現在の位置姿勢は変わりません。</translation>
    </message>
    <message>
        <source>After the import, projected points are at most %1 away from where the file projects them</source>
        <translation>インポート後、投影した点の位置は、ファイルによる投影位置から最大 %1 ずれます</translation>
    </message>
    <message>
        <source>Apply calibration</source>
        <translation>キャリブレーションを適用</translation>
    </message>
    <message>
        <source>default of the format</source>
        <translation>形式の標準</translation>
    </message>
    <message>
        <source>Lens model (4 coefficients)</source>
        <translation>レンズモデル（係数 4 個）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationMode</name>
    <message>
        <source>Calibration</source>
        <translation>校正</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraAgreementAlerts</name>
    <message>
        <source>Calibrate %1…</source>
        <translation>%1 をキャリブレーション…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraEdits</name>
    <message numerus="yes">
        <source>Add %n camera(s)</source>
        <translation>
            <numerusform>カメラ %n 台を追加</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove camera</source>
        <translation>カメラを削除</translation>
    </message>
    <message>
        <source>Replace camera</source>
        <translation>カメラを交換</translation>
    </message>
    <message>
        <source>Exchange cameras</source>
        <translation>カメラを入れ替え</translation>
    </message>
    <message>
        <source>Rename camera</source>
        <translation>カメラの名前を変更</translation>
    </message>
    <message>
        <source>Rotate images</source>
        <translation>画像を回転</translation>
    </message>
    <message>
        <source>Change image format</source>
        <translation>画像形式を変更</translation>
    </message>
    <message>
        <source>Change camera setting</source>
        <translation>カメラの設定を変更</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>色を固定</translation>
    </message>
    <message>
        <source>Crop images</source>
        <translation>画像をトリミング</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraForm</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>The camera to adjust; you can also click its image</source>
        <translation>調整するカメラ。画像をクリックしても選べます</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>Unit of positions</source>
        <translation>位置の単位</translation>
    </message>
    <message>
        <source>Unit for showing and entering positions</source>
        <translation>位置の表示と入力に使う単位</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>point, roll</source>
        <translation>注視点とロール</translation>
    </message>
    <message>
        <source>yaw, pitch, roll</source>
        <translation>ヨー、ピッチ、ロール</translation>
    </message>
    <message>
        <source>Direction format</source>
        <translation>向きの形式</translation>
    </message>
    <message>
        <source>Enter the direction as a point that the camera looks at, or as angles: yaw is measured from x toward y, pitch above the horizon, and roll about the line of sight</source>
        <translation>方向を、カメラが向く点、または角度で入力します。ヨーは x から y へ、ピッチは水平線から上へ、ロールは視線まわりに測ります</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>レンズ</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>焦点距離</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>画角</translation>
    </message>
    <message>
        <source>Lens parameter</source>
        <translation>レンズのパラメータ</translation>
    </message>
    <message>
        <source>Focal length in pixels, or the horizontal field of view in degrees</source>
        <translation>焦点距離(ピクセル)または水平画角(度)</translation>
    </message>
    <message>
        <source>Focal length or field of view</source>
        <translation>焦点距離または画角</translation>
    </message>
    <message>
        <source>Magnification of the camera; the keys + and − also change it</source>
        <translation>カメラの倍率。+ と − のキーでも変わります</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>ドラッグ</translation>
    </message>
    <message>
        <source>turns the camera</source>
        <translation>カメラを回す</translation>
    </message>
    <message>
        <source>slides the camera</source>
        <translation>カメラをずらす</translation>
    </message>
    <message>
        <source>Effect of dragging</source>
        <translation>ドラッグの働き</translation>
    </message>
    <message>
        <source>What the camera does while you drag the grid and no point is held. Click points of the grid to hold up to three of them.</source>
        <translation>点を固定せずに格子をドラッグしたときのカメラの動き。格子の点をクリックすると三つまで固定できます。</translation>
    </message>
    <message>
        <source>Also fit the focal length when three points are held</source>
        <translation>三点固定時は焦点距離を調整</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>What the keys do to the camera</source>
        <translation>キーによるカメラの動き</translation>
    </message>
    <message>
        <source>camera axes</source>
        <translation>カメラの軸</translation>
    </message>
    <message>
        <source>world axes</source>
        <translation>世界の軸</translation>
    </message>
    <message>
        <source>Axes along which the keys move the camera</source>
        <translation>キーでカメラを動かす方向の軸</translation>
    </message>
    <message>
        <source>Move along the camera&apos;s right, forward and up directions, or along the world axes</source>
        <translation>カメラの右・前・上の方向、または世界の軸に沿って動かします</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>ヨー</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>ピッチ</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>位置 %1</translation>
    </message>
    <message>
        <source>%1 coordinate of the camera&apos;s position</source>
        <translation>カメラの位置の %1 座標</translation>
    </message>
    <message>
        <source>Looks at (%1 coordinate)</source>
        <translation>注視点（%1 座標）</translation>
    </message>
    <message>
        <source>%1 coordinate of the point that the camera looks at</source>
        <translation>カメラの注視点の %1 座標</translation>
    </message>
    <message>
        <source>Direction seen from above: 0° along x, 90° along y</source>
        <translation>上から見た向き: x 方向が 0°、y 方向が 90°</translation>
    </message>
    <message>
        <source>Angle above the horizon; straight down is −90°</source>
        <translation>水平より上の角度。真下は −90°</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>ロール</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>ロール</translation>
    </message>
    <message>
        <source>Clockwise rotation about the line of sight</source>
        <translation>視線まわりの時計回りの回転</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>looks at</source>
        <translation>注視点</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>ヨー</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>ピッチ</translation>
    </message>
    <message>
        <source>Three held points fix the pose. With this option, dragging changes the focal length, and the pose is adapted so that the three points stay in place</source>
        <translation>三点を固定すると姿勢が決まります。このオプションでは、ドラッグすると焦点距離が変わり、三点が動かないように姿勢が調整されます</translation>
    </message>
    <message>
        <source>The arrow keys, the page keys and W, A, S, D, Q and E move or turn the camera by 1 cm or 0.2° a step. With Shift, the steps are ten times as large. With Ctrl, the steps of the arrow and page keys are a tenth as large.</source>
        <translation>矢印キー、PageUp/PageDown、W、A、S、D、Q、E でカメラを 1 回に 1 cm または 0.2° 動かすか回します。Shift を押すと 10 倍になります。Ctrl を押すと、矢印キーと Page キーでは 10 分の 1 になります。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraMotionAlerts</name>
    <message>
        <source>%1 was rotated by %2 (frame %3).</source>
        <translation>%1 が %2 回転しました（フレーム %3）。</translation>
    </message>
    <message>
        <source>The new pose of this camera is being computed.</source>
        <translation>このカメラの新しい姿勢を計算しています。</translation>
    </message>
    <message>
        <source>The pose of this camera can be recomputed from its images.</source>
        <translation>このカメラの姿勢は、その画像から計算し直せます。</translation>
    </message>
    <message>
        <source>Recompute pose of %1</source>
        <translation>%1 の姿勢を再計算</translation>
    </message>
    <message>
        <source>The pose of this camera cannot be recomputed from its images: calibrate the camera again, or move it back.</source>
        <translation>このカメラの姿勢は、その画像からは計算し直せません。カメラをキャリブレーションし直すか、元に戻してください。</translation>
    </message>
    <message>
        <source>Calibrate %1…</source>
        <translation>%1 をキャリブレーション…</translation>
    </message>
    <message>
        <source>%1 is back in its calibrated pose.</source>
        <translation>%1 はキャリブレーション時の姿勢に戻りました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraPanel</name>
    <message>
        <source>Rename camera</source>
        <translation>カメラの名前を変更</translation>
    </message>
    <message>
        <source>Change image source</source>
        <translation>画像の元を変更</translation>
    </message>
    <message>
        <source>Rotate images</source>
        <translation>画像を回転</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>表示やファイルで使うカメラの名前</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Video file, image folder, device, or stream address</source>
        <translation>動画ファイル、画像フォルダー、デバイス、または映像のアドレス</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the file, folder or device of this camera</source>
        <translation>このカメラのファイル、フォルダー、またはデバイスを選びます</translation>
    </message>
    <message>
        <source>Rotated</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, focal length %3 pixels
Position x, y, z: %4, %5, %6</source>
        <translation>%1 × %2 ピクセル、焦点距離 %3 ピクセル
位置 x, y, z: %4, %5, %6</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>画像フォルダーを選択</translation>
    </message>
    <message>
        <source>Choose the video for this camera</source>
        <translation>このカメラの動画を選択</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>画像を反転</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>Mirror the images left to right, after rotation</source>
        <translation>回転したあと、画像を左右に反転します</translation>
    </message>
    <message>
        <source>Background image</source>
        <translation>背景画像</translation>
    </message>
    <message>
        <source>Image, video or image folder that shows the scene without any target. Objects in the background that have the target&apos;s color are then not mistaken for the target</source>
        <translation>ターゲットのない場面を写した画像、動画、または画像フォルダー。これに写っているターゲットと同じ色の物は、ターゲットと間違えられなくなります</translation>
    </message>
    <message>
        <source>Choose background image</source>
        <translation>背景画像を選択</translation>
    </message>
    <message>
        <source>Choose an image or a video of the scene without any target</source>
        <translation>ターゲットのない場面の画像か動画を選びます</translation>
    </message>
    <message>
        <source>Use current image as background</source>
        <translation>現在の画像を背景に使う</translation>
    </message>
    <message>
        <source>Save the current image of this camera as its background image</source>
        <translation>このカメラの現在の画像を背景画像として保存します</translation>
    </message>
    <message>
        <source>Change background image</source>
        <translation>背景画像を変更</translation>
    </message>
    <message>
        <source>Choose a background image or video</source>
        <translation>背景の画像か動画を選択</translation>
    </message>
    <message>
        <source>Change delay</source>
        <translation>遅れを変更</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>遅れ</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>How late this camera&apos;s images are, in ms. Dewpoint uses this delay to synchronize the cameras. Calibration with a wand can measure the delay</source>
        <translation>このカメラの画像の遅れ（ミリ秒）。Dewpoint はこの値でカメラを同期させます。遅れはワンドによるキャリブレーションで測定できます</translation>
    </message>
    <message>
        <source>Delay of the images in milliseconds</source>
        <translation>画像が遅れているミリ秒数</translation>
    </message>
    <message>
        <source>Keep estimated delay</source>
        <translation>推定した遅延の採用</translation>
    </message>
    <message>
        <source>How far the images are rotated clockwise before they are used. The calibration is rotated with them</source>
        <translation>使用する前に画像を時計回りに回転する角度。キャリブレーションも一緒に回転します</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>キャリブレーションをインポート…</translation>
    </message>
    <message>
        <source>Import the calibration of the cameras from a file of Dewpoint or another program</source>
        <translation>Dewpoint またはほかのプログラムのファイルからカメラのキャリブレーションをインポートします</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraTable</name>
    <message>
        <source>rtsp://192.168.0.10/stream, or a device number such as 0</source>
        <translation>rtsp://192.168.0.10/stream、または 0 などのデバイス番号</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>読み込み中…</translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %3 frames per second · %n frames</source>
        <translation>
            <numerusform>✓ %1×%2 · 毎秒 %3 フレーム · %n フレーム</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %n images</source>
        <translation>
            <numerusform>✓ %1×%2 · 画像 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Live source: it is tested when the project is created</source>
        <translation>ライブ入力: プロジェクトの作成時に接続を試します</translation>
    </message>
    <message>
        <source>The videos have different frame rates: frame N does not show the same time in each of them.</source>
        <translation>動画のフレームレートが異なります: フレーム N はすべての動画で同じ時刻を示すわけではありません。</translation>
    </message>
    <message numerus="yes">
        <source>The videos differ in length: only the first %n frames are used.</source>
        <translation>
            <numerusform>動画の長さが異なります: 最初の %n フレームを使います。</numerusform>
        </translation>
    </message>
    <message>
        <source>The videos differ in size: each camera keeps its own size.</source>
        <translation>動画の大きさが異なります: 各カメラはそれぞれの大きさのままです。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CamerasDialog</name>
    <message>
        <source>Cameras – Dewpoint</source>
        <translation>カメラ – Dewpoint</translation>
    </message>
    <message>
        <source>Fit formats to the USB bus</source>
        <translation>形式を USB バスに合わせる</translation>
    </message>
    <message>
        <source>These formats fit the USB bus: %1.</source>
        <translation>USB バスに収まる形式: %1。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ChangesGuard</name>
    <message>
        <source>Save the project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml)</source>
        <translation>Dewpoint プロジェクト (*.toml)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>保存されていない変更</translation>
    </message>
    <message>
        <source>Save the changes to this project?</source>
        <translation>このプロジェクトの変更を保存しますか？</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorChoice</name>
    <message>
        <source>Color %1</source>
        <translation>色 %1</translation>
    </message>
    <message>
        <source>Show this color, so that its range can be changed by hand</source>
        <translation>ターゲットのこの色を表示し、範囲を手で変えられるようにする</translation>
    </message>
    <message>
        <source>Colors of the target</source>
        <translation>ターゲットの色</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Remove this color from the target, and the samples that show it</source>
        <translation>この色を、それを示す見本とともにターゲットから外す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorDock</name>
    <message>
        <source>Color</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Set box here</source>
        <translation>ここに枠を設定</translation>
    </message>
    <message>
        <source>Learn the color here</source>
        <translation>ここの色を学習</translation>
    </message>
    <message>
        <source>Add color sample here</source>
        <translation>ここの色を見本に追加</translation>
    </message>
    <message>
        <source>Exclude this color</source>
        <translation>この色を除外</translation>
    </message>
    <message>
        <source>Track this object, starting from a box around it</source>
        <translation>この物体を、それを囲む枠から追跡します</translation>
    </message>
    <message>
        <source>Learn the target&apos;s color from this spot</source>
        <translation>この位置でターゲットの色を学習します</translation>
    </message>
    <message>
        <source>Add this color to the colors of the target (Shift-click does the same)</source>
        <translation>この色をターゲットの色に加えます（Shift クリックでも可）</translation>
    </message>
    <message>
        <source>Remove this color from the colors of the target (Ctrl+Shift-click does the same)</source>
        <translation>この色をターゲットの色から除外します（Ctrl+Shift+クリックでも可）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLearner</name>
    <message>
        <source>No color can be learned here, because this camera shows no image.</source>
        <translation>このカメラには画像が表示されていないため、色を学習できません。</translation>
    </message>
    <message>
        <source>Click the target first. Then exclude colors of other objects.</source>
        <translation>まずターゲットをクリックし、その後でほかの物体の色を除外してください。</translation>
    </message>
    <message>
        <source>Exclude color</source>
        <translation>色を除外</translation>
    </message>
    <message>
        <source>Add color sample</source>
        <translation>色見本を追加</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>色を学習</translation>
    </message>
    <message>
        <source>Remove color sample</source>
        <translation>色見本を取り除く</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLocker</name>
    <message>
        <source>These settings of %1 cannot be locked: %2.</source>
        <translation>%1 の次の設定は固定できません: %2。</translation>
    </message>
    <message>
        <source>%1 has no control for these settings and may change them automatically: %2.</source>
        <translation>%1 には次の設定がなく、カメラが自動で変更することがあります: %2。</translation>
    </message>
    <message>
        <source>Only cameras that are connected to this computer can be locked. For network cameras, use their own settings.</source>
        <translation>固定できるのはこのコンピューターに接続されたカメラだけです。ネットワークカメラでは、カメラ自体の設定を使ってください。</translation>
    </message>
    <message>
        <source>The color settings of these cameras are now locked: %1.</source>
        <translation>次のカメラの色の設定を固定しました：%1。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>These cameras adjust their colors automatically: %1. The learned color may no longer fit when the light changes.</source>
        <translation>次のカメラは色を自動調整しています：%1。光が変わると、学習した色が合わなくなることがあります。</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>色を固定</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPanel</name>
    <message>
        <source>Analyzing images…</source>
        <translation>画像を調べています…</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>ターゲットなし</translation>
    </message>
    <message>
        <source>A new target</source>
        <translation>新しいターゲット</translation>
    </message>
    <message>
        <source>Click the object to track in any camera image.</source>
        <translation>どれかのカメラ画像で、追跡したい物体をクリックしてください。</translation>
    </message>
    <message>
        <source>Change color range</source>
        <translation>色の範囲を変更</translation>
    </message>
    <message>
        <source>Click the object to track</source>
        <translation>追跡したい物体をクリック</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it</source>
        <translation>物体をクリックするか、枠で囲む</translation>
    </message>
    <message>
        <source>The target is tracked from its box in frame %2 of %1 (%3 × %4 pixels). This method needs no color. To set another box, press Box and click the object.</source>
        <translation>ターゲットを、%1 のフレーム %2 の枠（%3 × %4 ピクセル）から追跡しています。この手法に色は要りません。別の枠にするには「枠」を押して物体をクリックします。</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>どれかのカメラ画像で、物体をクリックするか、枠で囲んでください。</translation>
    </message>
    <message>
        <source>Remove color</source>
        <translation>色を外す</translation>
    </message>
    <message>
        <source>To set the target&apos;s color, drag the ring and the bars, or press Learn and click the target.</source>
        <translation>ターゲットの色を設定するには、リングやバーをドラッグするか、「学習」を押してターゲットをクリックしてください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPicker</name>
    <message>
        <source>H&amp;ue</source>
        <translation>色相(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Saturation</source>
        <translation>彩度(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Intensity</source>
        <translation>輝度(&amp;I)</translation>
    </message>
    <message>
        <source>Start of the hue range, 0 to 360 degrees. If it is larger than the end, the range passes through red (0 degrees)</source>
        <translation>色相範囲の始まり（0〜360 度）。終わりより大きいと、範囲は赤（0 度）をまたぎます</translation>
    </message>
    <message>
        <source>End of the hue range, 0 to 360 degrees</source>
        <translation>色相範囲の終わり（0〜360度）</translation>
    </message>
    <message>
        <source>Drag the ends or the center of the range. Keyboard: Tab selects a handle, arrow keys move it (ten times as far with Shift)</source>
        <translation>範囲の両端または中央をドラッグします。キーボード：Tab でつまみを選び、矢印キーで動かします（Shift で 10 倍）</translation>
    </message>
    <message>
        <source>Range of hues</source>
        <translation>色相の範囲</translation>
    </message>
    <message>
        <source>Range of saturation</source>
        <translation>彩度の範囲</translation>
    </message>
    <message>
        <source>Range of intensity</source>
        <translation>輝度の範囲</translation>
    </message>
    <message>
        <source>Smallest saturation, 0 to 1</source>
        <translation>最小の彩度（0〜1）</translation>
    </message>
    <message>
        <source>Largest saturation, 0 to 1</source>
        <translation>最大の彩度（0〜1）</translation>
    </message>
    <message>
        <source>Smallest intensity, 0 to 1</source>
        <translation>最小の輝度（0〜1）</translation>
    </message>
    <message>
        <source>Largest intensity, 0 to 1</source>
        <translation>最大の輝度（0〜1）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorSampleList</name>
    <message>
        <source>Learned from</source>
        <translation>学習に使った見本</translation>
    </message>
    <message>
        <source>Samples from which the color was learned</source>
        <translation>色の学習に使った見本</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>excluded: %1, frame %2, pixel %3, %4</source>
        <translation>除外: %1、フレーム %2、ピクセル %3, %4</translation>
    </message>
    <message>
        <source>%1, frame %2, pixel %3, %4</source>
        <translation>%1、フレーム %2、ピクセル %3, %4</translation>
    </message>
    <message>
        <source>Remove the selected sample and learn from the others (Del). If the sample is marked “found”, it becomes an excluded sample.</source>
        <translation>選択した見本を削除し、残りから学習します (Del)。「検出」と表示された見本は除外見本になります。</translation>
    </message>
    <message>
        <source>Shift-click in an image to add a sample, Ctrl+Shift-click or Alt-click to exclude one. Samples marked “found” were detected in other cameras.</source>
        <translation>画像を Shift+クリックすると見本を追加し、Ctrl+Shift+クリックまたは Alt+クリックすると除外します。「検出」と表示された見本は、他のカメラで見つかったものです。</translation>
    </message>
    <message>
        <source>found: %1, frame %2, pixel %3, %4</source>
        <translation>検出：%1、フレーム %2、ピクセル %3, %4</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>何をしますか？</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>操作を検索</translation>
    </message>
    <message>
        <source>Actions found</source>
        <translation>見つかった操作</translation>
    </message>
    <message>
        <source>No action is called “%1”.</source>
        <translation>「%1」という操作はありません。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ControlForm</name>
    <message>
        <source>From %1 to %2; default %3</source>
        <translation>%1 から %2、既定値 %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionMode</name>
    <message>
        <source>Correct position</source>
        <translation>位置を修正</translation>
    </message>
    <message>
        <source>There is no correction in this frame.</source>
        <translation>このフレームに修正はありません。</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>修正を取り消す</translation>
    </message>
    <message>
        <source>Set the target&apos;s position in this frame to this point; tracking continues from there</source>
        <translation>このフレームでのターゲットの位置をこの点にします。そこから追跡を続けます</translation>
    </message>
    <message>
        <source>Drag the target to its true position in one image. To set its depth as well, do the same in a second image. Press Esc to finish.</source>
        <translation>1 つの画像の中でターゲットを実際の位置へドラッグします。奥行きも決めるには、別の画像でも同じようにします。Esc で終了します。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionTool</name>
    <message>
        <source>Drag the target to its true position</source>
        <translation>ターゲットを実際の位置へドラッグしてください</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter sets the target&apos;s position there</source>
        <translation>%1 の画像：矢印キーで十字を動かし、Enter でターゲットの位置を指定します</translation>
    </message>
    <message>
        <source>There is no target yet: learn its color first.</source>
        <translation>ターゲットがまだありません。先にその色を学習してください。</translation>
    </message>
    <message>
        <source>Frames are being tracked again: wait until tracking has finished, or pause it.</source>
        <translation>フレームを再追跡しています。追跡が終わるまで待つか、一時停止してください。</translation>
    </message>
    <message>
        <source>Select a target in the panel Target first, or drag the estimate of a target.</source>
        <translation>先に「ターゲット」パネルでターゲットを選ぶか、ターゲットの推定位置をドラッグしてください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CoverageMap</name>
    <message>
        <source>%1: %2 detections, in %3 of %4 regions of the image</source>
        <translation>%1: %2 回、画像の %4 区画のうち %3 区画で検出</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CrashReports</name>
    <message>
        <source>Dewpoint closed unexpectedly last time and left a report of what happened.</source>
        <translation>前回、Dewpoint は予期せず終了しました。そのときのレポートが残っています。</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>レポートを表示</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CropForm</name>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Pixels to cut off at this edge, after rotation and mirroring. The calibration is converted. Color samples and boxes in the part that is cut off are removed; Undo brings them back</source>
        <translation>回転と反転のあとにこの端で切り取るピクセル数。キャリブレーションは換算されます。切り取った部分にある色のサンプルと枠は削除されますが、「元に戻す」で復元できます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DelayEstimate</name>
    <message>
        <source>Keep</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>Add the estimated delay to the delay of this camera in the project</source>
        <translation>推定した遅延を、プロジェクトのこのカメラの遅延に加えます</translation>
    </message>
    <message>
        <source>This delay is estimated from the motion of the targets, and corrected while tracking. To switch this off, set the parameter “Delay spread” to 0</source>
        <translation>この遅延はターゲットの動きから推定し、追跡中に補正します。無効にするには、パラメーター「遅延のばらつき」を 0 にします</translation>
    </message>
    <message>
        <source>Estimate: %1 later than %2, ±%3</source>
        <translation>推定：%2 より %1 遅い、±%3</translation>
    </message>
    <message>
        <source>Estimate: %1 earlier than %2, ±%3</source>
        <translation>推定：%2 より %1 早い、±%3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DeviceQuestion</name>
    <message>
        <source>Use %1</source>
        <translation>%1 を使用</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>カメラ…</translation>
    </message>
    <message>
        <source>Several devices may be the camera %1 (%2). Which one is it?</source>
        <translation>カメラ %1 (%2) に該当しうるデバイスが複数あります。どれですか?</translation>
    </message>
    <message>
        <source>The device of the camera %1 is not connected: %2. Plug it in, or choose another one.</source>
        <translation>カメラ %1 のデバイスが接続されていません: %2。接続するか、別のデバイスを選んでください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DockTitle</name>
    <message>
        <source>Float or dock this view (to maximize the view, double-click its title)</source>
        <translation>このビューを切り離す、またはドッキングする（タイトルをダブルクリックすると最大化）</translation>
    </message>
    <message>
        <source>Show all views</source>
        <translation>すべてのビューを表示</translation>
    </message>
    <message>
        <source>Restore the other views (Esc, or double-click here)</source>
        <translation>ほかのビューを元に戻します（Esc、またはここをダブルクリック）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Document</name>
    <message>
        <source>Change “%1”</source>
        <translation>「%1」を変更</translation>
    </message>
    <message>
        <source>Track with method “%1”</source>
        <translation>手法「%1」で追跡</translation>
    </message>
    <message>
        <source>Reset “%1”</source>
        <translation>「%1」を既定値に戻す</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>すべてのパラメータを既定値に戻す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DropZone</name>
    <message>
        <source>Drop or click to add videos</source>
        <translation>動画をドロップまたはクリックして追加</translation>
    </message>
    <message>
        <source>One video or image folder per camera; you can also drop a calibration file</source>
        <translation>カメラごとに動画または画像フォルダーを 1 つ。キャリブレーションファイルもドロップできます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExchangeDialog</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>The file, or the folder with a file for each camera</source>
        <translation>ファイル、またはカメラごとのファイルがあるフォルダー</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>ファイルを選択</translation>
    </message>
    <message>
        <source>Choose the file to read or write</source>
        <translation>ファイルを探す</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Choose a file. A preview of the result is shown here before anything changes.</source>
        <translation>ファイルを選択してください。変更の前に、結果のプレビューがここに表示されます。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close without changing anything</source>
        <translation>何も変更せずに閉じる</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExperimentDialog</name>
    <message>
        <source>Canceled.</source>
        <translation>中止しました。</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>Folder for the report, its pictures and its numbers</source>
        <translation>レポート、図、数値を保存するフォルダー</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the folder of the report</source>
        <translation>レポートのフォルダーを選びます</translation>
    </message>
    <message>
        <source>Experiment progress</source>
        <translation>実験の進み具合</translation>
    </message>
    <message>
        <source>Run the chosen experiment (Enter)</source>
        <translation>選んだ実験を実行します(Enter)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop the experiment without writing anything</source>
        <translation>実験を止めます。何も書き込みません</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>レポートを開く</translation>
    </message>
    <message>
        <source>Show the last report in the web browser</source>
        <translation>最後のレポートをブラウザーで表示します</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>レポートのフォルダー</translation>
    </message>
    <message>
        <source>Choose the folder for the report first.</source>
        <translation>先にレポートのフォルダーを指定してください。</translation>
    </message>
    <message>
        <source>Running “%1”…</source>
        <translation>「%1」を実行中…</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>レポートは %1 にあります。</translation>
    </message>
    <message>
        <source>Runs per case</source>
        <translation>1条件あたりの回数</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Recordings folder</source>
        <translation>録画のフォルダー</translation>
    </message>
    <message>
        <source>Clothes</source>
        <translation>服</translation>
    </message>
    <message>
        <source>Whether the simulated people wear different clothes</source>
        <translation>シミュレーションの人が異なる服を着るかどうか</translation>
    </message>
    <message>
        <source>both kinds</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>different</source>
        <translation>異なる</translation>
    </message>
    <message>
        <source>similar</source>
        <translation>似ている</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>録画</translation>
    </message>
    <message>
        <source>no folder: only a rendered clip</source>
        <translation>フォルダーなし：計算で作った映像のみ</translation>
    </message>
    <message>
        <source>Folder with the recordings juggle1 and otb; without a folder, only a rendered clip is used</source>
        <translation>録画 juggle1 と otb のあるフォルダー。なければ計算で作った映像だけを使います</translation>
    </message>
    <message>
        <source>Choose the folder of the recordings</source>
        <translation>録画のフォルダーを選ぶ</translation>
    </message>
    <message>
        <source>How often each case is run, each time with another seed. More runs take longer and give more certain results.</source>
        <translation>各ケースを、毎回別のシードで何回実行するか。多いほど時間がかかり、結果が確かになります。</translation>
    </message>
    <message>
        <source>No program was found that can show the report. The report is in %1.</source>
        <translation>レポートを表示するプログラムが見つかりません。レポートは %1 にあります。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportDialog</name>
    <message>
        <source>Export trajectory</source>
        <translation>軌跡の書き出し</translation>
    </message>
    <message>
        <source>Save figure</source>
        <translation>図を保存</translation>
    </message>
    <message>
        <source>Figures (*.svg *.pdf)</source>
        <translation>図 (*.svg *.pdf)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>時間 (s)</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>書き出しを中止しました。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>書き出すファイル</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>参照…</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>書き出すファイルを選びます</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop the export or the preview; files that already exist stay unchanged</source>
        <translation>書き出しまたはプレビューを止めます。既にあるファイルは変わりません</translation>
    </message>
    <message>
        <source>Figure…</source>
        <translation>図…</translation>
    </message>
    <message>
        <source>Save a figure of the trajectory as SVG or PDF: x, y, z over time, and the view from above</source>
        <translation>軌跡の図を SVG または PDF で保存します（x、y、z の時間変化と上から見た図）</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Write the file in the background</source>
        <translation>ファイルをバックグラウンドで書き出します</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; a running export continues</source>
        <translation>閉じます。実行中の書き出しは続きます</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 はすでに存在します。置き換えますか？</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 はすでに存在するため、何も書き込みませんでした。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>The program that will read the file</source>
        <translation>ファイルを読むプログラム</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>Only checked targets are exported; if none is checked, all are exported</source>
        <translation>チェックしたターゲットだけを書き出します。チェックがなければすべて書き出します</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>推定値</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>頻度</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>欠落</translation>
    </message>
    <message>
        <source>What to write while the position is unknown</source>
        <translation>位置が不明な間に何を書くか</translation>
    </message>
    <message>
        <source>Longest gap</source>
        <translation>最長の欠落</translation>
    </message>
    <message>
        <source>Longest gap to fill, 0.01 to 60 s</source>
        <translation>埋める欠落の最大の長さ（0.01〜60 s）</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>世界座標軸</translation>
    </message>
    <message>
        <source>Axis that points up in the file</source>
        <translation>ファイルで上を向く軸</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Unit of positions in the file</source>
        <translation>ファイル内の位置の単位</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>最初</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>最後</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>録画のまま</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> 回/秒</translation>
    </message>
    <message>
        <source>smoothed after the run</source>
        <translation>実行後に平滑化</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>残す</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>埋める</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z が上</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y が上</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>Earliest time to export, 0 to 1,000,000 s</source>
        <translation>書き出す最初の時刻（0〜1,000,000 s）</translation>
    </message>
    <message>
        <source>Latest time to export, 0 to 1,000,000 s</source>
        <translation>書き出す最後の時刻（0〜1,000,000 s）</translation>
    </message>
    <message>
        <source>Rows per second, 0.001 to 10,000. Positions between frames are interpolated</source>
        <translation>1秒あたりの行数（0.001〜10,000）。フレーム間の位置は補間します</translation>
    </message>
    <message>
        <source>As tracked: estimated during the run, from earlier frames alone. Smoothed: estimated after the run, from earlier and later frames</source>
        <translation>追跡中の値：実行中に、それより前のフレームだけから推定した値。平滑化：実行の後に、前後のフレームから推定した値</translation>
    </message>
    <message>
        <source>Notes at the top of the file</source>
        <translation>ファイルの先頭に情報を書く</translation>
    </message>
    <message>
        <source>Lines that describe the run: method, seed, parameters, units and axes. Without them, a CSV file begins with the names of its columns. TRC and C3D files have no notes</source>
        <translation>実行を説明する行です：手法、シード、パラメータ、単位、軸。これがないと、CSV ファイルは列名から始まります。TRC と C3D のファイルにはこの情報はありません</translation>
    </message>
    <message>
        <source>as tracked (live)</source>
        <translation>追跡中の値（ライブ）</translation>
    </message>
    <message>
        <source>%1 (usual for this format)</source>
        <translation>%1（この形式の標準）</translation>
    </message>
    <message>
        <source>tracked only up to %1</source>
        <translation>追跡済みは %1 まで</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportOutcome</name>
    <message>
        <source>Show in folder</source>
        <translation>フォルダーに表示</translation>
    </message>
    <message>
        <source>Open the folder of the file that was written</source>
        <translation>書き出したファイルのフォルダーを開きます</translation>
    </message>
    <message>
        <source>No file manager was found. The path of the file is %1.</source>
        <translation>ファイルマネージャーが見つかりません。ファイルのパスは %1 です。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExposureBars</name>
    <message>
        <source>Brightness of the target&apos;s pixels</source>
        <translation>ターゲットのピクセルの明るさ</translation>
    </message>
    <message>
        <source>Brightness of the target&apos;s pixels, from black on the left to white on the right. The highlighted bars at the two ends count pixels that are too dark or overexposed: these pixels have lost their color.</source>
        <translation>ターゲットのピクセルの明るさ。左が黒、右が白です。両端の強調された棒は、暗すぎるピクセルと露出オーバーのピクセルの数です。これらのピクセルは色を失っています。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExposureView</name>
    <message>
        <source>Exposure: no target is visible in this camera</source>
        <translation>露出: このカメラにはターゲットが写っていません</translation>
    </message>
    <message>
        <source>Exposure of %1</source>
        <translation>%1の露出</translation>
    </message>
    <message>
        <source>%1 % overexposed · %2 % too dark</source>
        <translation>露出オーバー %1 %・暗すぎ %2 %</translation>
    </message>
    <message>
        <source>%1: %2 % of the target&apos;s pixels are overexposed. Lower the exposure.</source>
        <translation>%1: ターゲットのピクセルの%2 %が露出オーバーです。露出を下げてください。</translation>
    </message>
    <message>
        <source>%1: %2 % of the target&apos;s pixels are too dark. Raise the exposure, or add light.</source>
        <translation>%1: ターゲットのピクセルの%2 %が暗すぎます。露出を上げるか、照明を追加してください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FollowAllButton</name>
    <message numerus="yes">
        <source>Follow all %n objects</source>
        <translation>
            <numerusform>%n 個すべてを追跡</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a target for each of the other objects of this color and size</source>
        <translation>この色と大きさのほかの物体それぞれに、ターゲットを追加します</translation>
    </message>
    <message>
        <source>Follow all objects of one color</source>
        <translation>同じ色の物をすべて追跡</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FormatChoice</name>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Format in which the device sends its images. Compressed formats, such as MJPG, use less of the bandwidth of the USB bus</source>
        <translation>デバイスが画像を送る形式。MJPG などの圧縮形式は USB バスの帯域の使用量が少なくなります</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Size of the images, in pixels</source>
        <translation>画像のサイズ (ピクセル)</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>頻度</translation>
    </message>
    <message>
        <source>Images per second</source>
        <translation>1 秒あたりの画像数</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FrameField</name>
    <message>
        <source>Frame, or time in s</source>
        <translation>フレーム、または秒 (s)</translation>
    </message>
    <message>
        <source>Frame number or time to go to</source>
        <translation>移動先のフレーム番号または時刻</translation>
    </message>
    <message>
        <source>Enter a frame from %1 to %2, or a time from %3 to %4.</source>
        <extracomment>%1 and %2 are numbers of frames, %3 and %4 times</extracomment>
        <translation>%1～%2 のフレーム、または %3～%4 の時刻を入力してください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GalleryCard</name>
    <message>
        <source>Opening…</source>
        <translation>開いています…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GapList</name>
    <message>
        <source>Gaps of the trajectory</source>
        <translation>軌跡の途切れ</translation>
    </message>
    <message>
        <source>gap from</source>
        <translation>途切れの始め</translation>
    </message>
    <message>
        <source>to</source>
        <translation>終わり</translation>
    </message>
    <message>
        <source>length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>target</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>フレーム %1</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n フレーム</numerusform>
        </translation>
    </message>
    <message>
        <source>Time in seconds between the last tracked frame before the gap and the first tracked frame after it</source>
        <translation>途切れ前の最後の追跡フレームから、その後の最初の追跡フレームまでの秒数</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridForm</name>
    <message>
        <source>Change the reference grid</source>
        <translation>基準格子を変更</translation>
    </message>
    <message>
        <source>Grid on</source>
        <translation>格子の場所</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>a wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>箱</translation>
    </message>
    <message>
        <source>Kind of grid</source>
        <translation>格子の種類</translation>
    </message>
    <message>
        <source>Surface of the room on which the grid lies</source>
        <translation>格子を置く部屋の面</translation>
    </message>
    <message>
        <source>Size along x, y, z</source>
        <translation>x、y、z 方向の大きさ</translation>
    </message>
    <message>
        <source>Origin x, y, z</source>
        <translation>原点 x、y、z</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>%1 方向の大きさ</translation>
    </message>
    <message>
        <source>Size of the grid, in meters</source>
        <translation>格子の大きさ（メートル）</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>原点 %1</translation>
    </message>
    <message>
        <source>Spacing, rotation</source>
        <translation>間隔、回転</translation>
    </message>
    <message>
        <source>Spacing of the grid</source>
        <translation>格子の間隔</translation>
    </message>
    <message>
        <source>Distance between lines, in meters</source>
        <translation>線と線の間隔(メートル)</translation>
    </message>
    <message>
        <source>Rotation of the grid</source>
        <translation>格子の回転</translation>
    </message>
    <message>
        <source>Rotation about the vertical, counterclockwise as seen from above</source>
        <translation>鉛直軸まわりの回転(上から見て反時計回り)</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Opacity of the grid</source>
        <translation>格子の不透明度</translation>
    </message>
    <message>
        <source>How strongly the grid is drawn over the images</source>
        <translation>画像の上に格子を描く濃さ</translation>
    </message>
    <message>
        <source>Show image edges</source>
        <translation>画像の輪郭を表示</translation>
    </message>
    <message>
        <source>Dim the images except for their edges</source>
        <translation>輪郭以外を暗くします</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>前の状態</translation>
    </message>
    <message>
        <source>Position of the corner at which the axes of the grid start, in meters</source>
        <translation>格子の軸が始まる角の位置（メートル）</translation>
    </message>
    <message>
        <source>Show the grid with the camera poses before the changes</source>
        <translation>変更前のカメラの姿勢で格子を表示</translation>
    </message>
    <message>
        <source>Hold down this button to draw the grid with earlier camera poses. Choose below which earlier poses are used. The key B does the same after you have clicked an image</source>
        <translation>このボタンを押している間、以前のカメラの姿勢で格子を描きます。どの時点の姿勢を使うかは下で選びます。画像をクリックした後は B キーでも同じです</translation>
    </message>
    <message>
        <source>Before shows</source>
        <translation>「前の状態」の表示</translation>
    </message>
    <message>
        <source>poses when the panel was opened</source>
        <translation>パネルを開いたときのカメラ</translation>
    </message>
    <message>
        <source>poses before the last change</source>
        <translation>最後の変更前のカメラ</translation>
    </message>
    <message>
        <source>Earlier camera poses that the button Before shows</source>
        <translation>ボタン「前の状態」で表示するカメラの姿勢</translation>
    </message>
    <message>
        <source>The cameras as they were when you opened this panel, or as they were before the last step that changed a camera</source>
        <translation>このパネルを開いたときのカメラ、またはカメラを最後に変更した操作の前のカメラ</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridLayer</name>
    <message>
        <source>Grid over the image of %1</source>
        <translation>%1 の画像の格子</translation>
    </message>
    <message>
        <source>Drag the grid onto the real scene. Click a point to hold it. Arrow keys, W A S D, Q and E move or rotate the camera</source>
        <translation>格子を実際の場面に重ねるようにドラッグします。クリックで点を固定します。矢印、W A S D、Q、E でカメラを移動・回転します</translation>
    </message>
    <message>
        <source>before</source>
        <translation>前</translation>
    </message>
    <message>
        <source>The earlier grid is outside the visible part of the image</source>
        <translation>以前の格子は画像の見えている部分の外にあります</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GuidePage</name>
    <message>
        <source>Calibrate…</source>
        <translation>キャリブレーション…</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Calibration so far</source>
        <translation>これまでのキャリブレーション</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>レンズ</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>遅延</translation>
    </message>
    <message>
        <source>Calibration of each camera so far</source>
        <translation>各カメラのこれまでのキャリブレーション</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Show the previous step</source>
        <translation>前のステップを表示</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
    <message>
        <source>Show the next step</source>
        <translation>次のステップを表示</translation>
    </message>
    <message>
        <source>%1 Scale: %2</source>
        <translation>%1 縮尺: %2</translation>
    </message>
    <message>
        <source>%1 Floor and upward direction: %2</source>
        <translation>%1 床と上方向: %2</translation>
    </message>
    <message>
        <source>✓ Accuracy in the calibrated volume: %1 (95 %)</source>
        <translation>✓ キャリブレーションした空間での精度: %1 (95 %)</translation>
    </message>
    <message>
        <source>○ Accuracy in the calibrated volume: not measured</source>
        <translation>○ キャリブレーションした空間での精度: 未測定</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>ステップ %1/%2: %3</translation>
    </message>
    <message>
        <source>Another way…</source>
        <translation>別の方法…</translation>
    </message>
    <message>
        <source>Choose a way to calibrate</source>
        <translation>キャリブレーションの方法を選ぶ</translation>
    </message>
    <message>
        <source>The camera positions are only guesses. Calibrate the cameras to get correct 3D positions.</source>
        <translation>カメラの位置は推測にすぎません。正しい 3D 位置を得るには、カメラをキャリブレーションしてください。</translation>
    </message>
    <message>
        <source>✓ measured with this program; ± is the standard deviation. ○ entered, set by hand or read from a file, and not checked. ⚠ only a guess, or too inaccurate.</source>
        <translation>✓ このプログラムで測定済み。± は標準偏差です。○ 入力、手動設定、またはファイルからの値で、確認されていません。⚠ 推測にすぎないか、誤差が大きすぎます。</translation>
    </message>
    <message>
        <source>Show all ways to calibrate. The calibration so far is kept.</source>
        <translation>キャリブレーションのすべての方法を表示します。これまでのキャリブレーションは残ります。</translation>
    </message>
    <message>
        <source>✓ Length check: you measured %1, the calibration gives %2</source>
        <translation>✓ 長さの確認: 計測値 %1、キャリブレーションの値 %2</translation>
    </message>
    <message>
        <source>○ Accuracy outside this volume: %1 (95 %, extrapolated)</source>
        <translation>○ この空間の外での精度: %1（95 %、外挿）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistogramView</name>
    <message>
        <source>Colors of the box</source>
        <translation>枠の色</translation>
    </message>
    <message>
        <source>Color histograms of the bounding box: outlined bars for the reference, filled bars for the current frame. The largest of the 512 bins are shown, each in its own color.</source>
        <translation>枠の色ヒストグラム：中空の棒は指定時、塗りつぶした棒は現在です。512個のビンのうち大きいものを、それぞれの色で表示します。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistoryDock</name>
    <message>
        <source>Initial state</source>
        <translation>開いたときの状態</translation>
    </message>
    <message>
        <source>History of changes</source>
        <translation>変更の履歴</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>元に戻す: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>やり直し: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ImagePickTool</name>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter clicks there</source>
        <translation>%1 の画像: 矢印キーで十字を動かし、Enter でその場所をクリックします</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LearnModes</name>
    <message>
        <source>What a click in an image does</source>
        <translation>画像でのクリックの働き</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>学習</translation>
    </message>
    <message>
        <source>Add sample</source>
        <translation>見本を追加</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Learn the color first: click the target in a camera image.</source>
        <translation>先に色を学習してください。カメラ画像のターゲットをクリックします。</translation>
    </message>
    <message>
        <source>Click: exclude a color · Esc: stop</source>
        <translation>クリック：色を除外 · Esc：終了</translation>
    </message>
    <message>
        <source>Click the object in a camera image, or drag a box around it.
When this button is off, Shift-click does the same.</source>
        <translation>カメラ画像で物体をクリックするか、枠で囲みます。
このボタンがオフのときは、Shift クリックで同じことができます。</translation>
    </message>
    <message>
        <source>Click another part of the target, or the target in different light, to add its color.
When this button is off, Shift-click does the same.</source>
        <translation>ターゲットの別の部分、または別の光の当たり方のターゲットをクリックして、その色を加えます。
このボタンがオフのときは、Shift クリックで同じことができます。</translation>
    </message>
    <message>
        <source>Click the target in a camera image, or drag a box around it,
to learn its color again.</source>
        <translation>カメラ画像でターゲットをクリックするか、囲む枠をドラッグすると、
色を学習し直します。</translation>
    </message>
    <message>
        <source>Click something that has the target&apos;s color but is not the target, to exclude it.
When this button is off, Ctrl+Shift-click does the same; so does Alt-click, where the desktop does not use it.</source>
        <translation>ターゲットの色をしているがターゲットではない物をクリックして除外します。
このボタンがオフのときは、Ctrl+Shift+クリックで同じことができます。デスクトップが使っていなければ Alt+クリックでもできます。</translation>
    </message>
    <message>
        <source>Click: add a sample · Ctrl+Shift: exclude · Esc: stop</source>
        <translation>クリック：見本を追加 · Ctrl+Shift：除外 · Esc：終了</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Ctrl+Shift: exclude · Esc: stop</source>
        <translation>クリック：学習 · Shift：追加 · Ctrl+Shift：除外 · Esc：終了</translation>
    </message>
    <message>
        <source>Click: add a sample · Esc: stop</source>
        <translation>クリック：見本を追加 · Esc：終了</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Esc: stop</source>
        <translation>クリック：学習 · Shift：追加 · Esc：終了</translation>
    </message>
    <message>
        <source>Click the new target · Esc: stop</source>
        <translation>新しいターゲットをクリック · Esc：終了</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LegendPicture</name>
    <message>
        <source>Cross: the estimate, the weighted mean of the particles.</source>
        <translation>十字：推定。粒子の重み付き平均です。</translation>
    </message>
    <message>
        <source>Solid ellipse: the target is inside with a probability of 95 %. A smaller ellipse is more certain.</source>
        <translation>実線の楕円：95 % の確率でターゲットはこの中にあります。小さいほど確かです。</translation>
    </message>
    <message>
        <source>White diamond: the true position of the target, known only in simulated scenes such as the demo.</source>
        <translation>白いひし形：ターゲットの真の位置。デモなどシミュレーションのシーンでだけ分かります。</translation>
    </message>
    <message>
        <source>Triangle: the particle of highest weight (View › Show best particle).</source>
        <translation>三角形：重みが最大の粒子（表示 › 最良の粒子を表示）。</translation>
    </message>
    <message>
        <source>Line across the image: the line of sight of another camera, shown while you drag the target. The target must lie on this line.</source>
        <translation>画像を横切る線：ターゲットをドラッグする間に示される、他のカメラの視線。ターゲットはこの線上にあるはずです。</translation>
    </message>
    <message>
        <source>Dots: particles. Each one is a guess of where the target is. Brighter particles fit the images better.</source>
        <translation>点：粒子。それぞれがターゲットの位置の推測です。明るいほど画像によく合います。</translation>
    </message>
    <message>
        <source>Tinted and outlined: regions with the color of the target (View › Show mask).</source>
        <translation>色と輪郭の付いた所：ターゲットの色を持つ領域（表示 › マスクを表示）。</translation>
    </message>
    <message>
        <source>Dashed ellipse: the size of the target itself, if the target is not a ball.</source>
        <translation>破線の楕円：ターゲットがボールでない場合の、ターゲット自体の大きさ。</translation>
    </message>
    <message>
        <source>Box in a corner: the particles, enlarged, if they are too close together to be seen in the view. A line shows where they are, and the bar shows the scale.</source>
        <translation>隅の枠：粒子が密集していて見分けられないときの拡大図。線は粒子の位置を、バーは縮尺を示します。</translation>
    </message>
    <message>
        <source>Dark band along a path in the bird&apos;s-eye view: the time range that is selected in the timeline. Press Esc in the timeline to remove the selection.</source>
        <translation>鳥瞰図の軌跡に沿った暗い帯：タイムラインで選択した時間範囲。タイムラインで Esc を押すと選択を解除します。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MainWindow</name>
    <message>
        <source>Dewpoint</source>
        <translation>Dewpoint</translation>
    </message>
    <message>
        <source>%1[*] – Dewpoint</source>
        <translation>%1[*] – Dewpoint</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibration</name>
    <message>
        <source>Drag the grid in %1</source>
        <translation>%1 で格子をドラッグ</translation>
    </message>
    <message>
        <source>Cannot move further: a grid point would leave the camera&apos;s field of view</source>
        <translation>これ以上は動きません: 格子点がカメラの視界から外れます</translation>
    </message>
    <message>
        <source>Cannot move further: this grid point and the held grid points lie on one line</source>
        <translation>これ以上は動きません: この格子点と固定した格子点が一直線上にあります</translation>
    </message>
    <message>
        <source>Cannot move further: no nearby camera pose keeps the held grid points in place</source>
        <translation>これ以上は動きません: 近くに、固定した格子点を保つカメラの姿勢がありません</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>前</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>ピッチ</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>ロール</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>ヨー</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>%1: change focal length by %2 %</source>
        <translation>%1: 焦点距離を %2 % 変更</translation>
    </message>
    <message>
        <source>At most three grid points can be held in place. To release one, click it</source>
        <translation>固定できる格子点は 3 つまでです。固定を解除するには、その点をクリックします</translation>
    </message>
    <message>
        <source>Three held points fix the pose. Release one of them, or turn on “Also fit the focal length when three points are held”</source>
        <translation>三点を固定すると姿勢が決まります。一つを外すか、「三点固定時は焦点距離を調整」をオンにしてください</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibrationPage</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Reference grid</source>
        <translation>基準格子</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>Drag the grid in an image until it matches the real scene. Click a grid point to hold it in place. Turn the wheel to zoom; double-click beside the grid points to see the whole image.</source>
        <translation>画像の中で格子を実際の場面に重なるまでドラッグします。格子の点をクリックするとそこに固定されます。ホイールで拡大し、格子の点から離れた場所をダブルクリックすると画像全体を表示します。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualWindow</name>
    <message>
        <source>Manual – Dewpoint</source>
        <translation>マニュアル – Dewpoint</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>マニュアルのページ</translation>
    </message>
    <message>
        <source>Go back to the previous page</source>
        <translation>前のページに戻ります</translation>
    </message>
    <message>
        <source>Go forward one page</source>
        <translation>次のページへ進みます</translation>
    </message>
    <message>
        <source>The manual was not found. It is expected in the folder %1.</source>
        <translation>マニュアルが見つかりません。フォルダー %1 にあるはずです。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MarkerEditor</name>
    <message>
        <source>Name of the marker</source>
        <translation>マークの名前</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>マーク %1</translation>
    </message>
    <message>
        <source>Add a marker</source>
        <translation>マークを追加</translation>
    </message>
    <message>
        <source>Remove a marker</source>
        <translation>マークを削除</translation>
    </message>
    <message>
        <source>Rename a marker</source>
        <translation>マークの名前を変更</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageHistory</name>
    <message>
        <source>Messages – Dewpoint</source>
        <translation>メッセージ – Dewpoint</translation>
    </message>
    <message>
        <source>Messages, the newest last</source>
        <translation>メッセージ（最新のものが最後）</translation>
    </message>
    <message>
        <source>There have been no messages yet.</source>
        <translation>まだメッセージはありません。</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy all messages as text</source>
        <translation>すべてのメッセージをテキストとしてコピーします</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageRow</name>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MissingFilesOffer</name>
    <message>
        <source>%1 was not found in %2.</source>
        <translation>%1 が %2 に見つかりません。</translation>
    </message>
    <message numerus="yes">
        <source>%n files of this project were not found: %1.</source>
        <translation>
            <numerusform>このプロジェクトの %n 個のファイルが見つかりません：%1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>場所を指定…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 の場所を指定</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>The project was opened with the files that you located. Save the project to keep their new paths.</source>
        <translation>指定されたファイルでプロジェクトを開きました。新しいパスを残すには、プロジェクトを保存してください。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a file, the name of its camera</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::NewProjectPage</name>
    <message>
        <source>New project</source>
        <translation>新しいプロジェクト</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>動画ファイル（カメラごとに1つ）</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>フレームごとに1枚の画像が入ったフォルダー</translation>
    </message>
    <message>
        <source>All cameras connected to this computer</source>
        <translation>このコンピューターに接続されたすべてのカメラ</translation>
    </message>
    <message>
        <source>Enter a device number or a network stream</source>
        <translation>デバイス番号またはネットワーク映像を入力します</translation>
    </message>
    <message>
        <source>Remove the selected cameras</source>
        <translation>選んだカメラを取り除きます</translation>
    </message>
    <message>
        <source>Create the project and show its first images</source>
        <translation>プロジェクトを作成し、最初の画像を表示します</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Go back without creating a project</source>
        <translation>プロジェクトを作成せずに戻ります</translation>
    </message>
    <message>
        <source>Name of the project</source>
        <translation>プロジェクトの名前</translation>
    </message>
    <message>
        <source>Frame rate of image folders, 0.1 to 10,000 per second</source>
        <translation>画像フォルダーのフレームレート、毎秒0.1〜10,000枚</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Images from</source>
        <translation>画像の元</translation>
    </message>
    <message>
        <source>Cameras in the new project</source>
        <translation>新しいプロジェクトのカメラ</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>カメラごとに動画を選択</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>動画 (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>画像フォルダーを選択</translation>
    </message>
    <message>
        <source>No camera is connected to this computer. A network camera can be added by its address.</source>
        <translation>このコンピューターにはカメラが接続されていません。ネットワークカメラはアドレスで追加できます。</translation>
    </message>
    <message>
        <source>The calibration uses other camera names. The cameras were matched by order.</source>
        <translation>キャリブレーションのカメラ名が異なるため、順番で対応づけました。</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>動画を追加…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>画像フォルダーを追加…</translation>
    </message>
    <message>
        <source>Add connected cameras</source>
        <translation>接続されたカメラを追加</translation>
    </message>
    <message>
        <source>Add address</source>
        <translation>アドレスを追加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>作成</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>名前:</translation>
    </message>
    <message>
        <source>Images per second:</source>
        <translation>1秒あたりの画像数:</translation>
    </message>
    <message>
        <source>Not a video, image or calibration file: %1.</source>
        <translation>動画、画像、キャリブレーションのファイルではありません: %1。</translation>
    </message>
    <message>
        <source>One row per camera. The videos must be synchronized: frame N must show the same time in all of them.</source>
        <translation>カメラごとに1行。動画は同期している必要があります: フレーム N はすべての動画で同じ時刻を示さなければなりません。</translation>
    </message>
    <message>
        <source>(folder name)</source>
        <translation>（フォルダー名）</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>検出結果</translation>
    </message>
    <message>
        <source>%1. Create the project without this file, then choose Calibration › Import calibration.</source>
        <translation>%1。このファイルなしでプロジェクトを作成し、その後「キャリブレーション › キャリブレーションをインポート」を選んでください。</translation>
    </message>
    <message>
        <source>Probably a mistake in the calibration: %1</source>
        <translation>キャリブレーションがおそらく誤っています: %1</translation>
    </message>
    <message>
        <source>%1. Choose below how the images differ from those of the calibration.</source>
        <translation>%1。画像がキャリブレーションの画像とどう違うかを下で選んでください。</translation>
    </message>
    <message>
        <source>%1. For each camera of the project, choose a camera of the file below.</source>
        <translation>%1。プロジェクトの各カメラに対応するファイルのカメラを下で選んでください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::NoticeList</name>
    <message>
        <source>Hide these notices. The status bar shows how many are hidden</source>
        <translation>これらの通知を隠します。隠した数はステータスバーに表示されます</translation>
    </message>
    <message numerus="yes">
        <source>and %n more notice(s)</source>
        <translation>
            <numerusform>ほか %n 件の通知</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OldResultsOffer</name>
    <message>
        <source>Track again</source>
        <translation>再追跡</translation>
    </message>
    <message>
        <source>Some frames were tracked with earlier settings.</source>
        <translation>以前の設定で追跡したフレームがあります。</translation>
    </message>
    <message>
        <source>Tracking began at frame %1, where you clicked. The frames before it are not tracked.</source>
        <translation>クリックしたフレーム %1 から追跡を開始しました。それより前のフレームは追跡されていません。</translation>
    </message>
    <message>
        <source>Track from the first frame</source>
        <translation>最初のフレームから追跡</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OutputController</name>
    <message>
        <source>%1: %2 sent, %3 dropped</source>
        <translation>%1: 送信 %2、破棄 %3</translation>
    </message>
    <message numerus="yes">
        <source>Sending, %n program(s) connected</source>
        <translation>
            <numerusform>送信中、接続 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Sending</source>
        <translation>送信中</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OutputDialog</name>
    <message>
        <source>Change outputs</source>
        <translation>出力を変更</translation>
    </message>
    <message>
        <source>Outputs – Dewpoint</source>
        <translation>出力 – Dewpoint</translation>
    </message>
    <message>
        <source>Choose where results are sent during a run. Nothing is sent before you choose Run › Send results.</source>
        <translation>実行中の結果の送信先を選びます。「実行 › 結果を送信」を選ぶまで何も送信されません。</translation>
    </message>
    <message>
        <source>TCP port for JSON lines</source>
        <translation>JSON 行の TCP ポート</translation>
    </message>
    <message>
        <source>Programs that connect to this port get one line of JSON for each frame</source>
        <translation>このポートに接続したプログラムは、フレームごとに 1 行の JSON を受け取ります</translation>
    </message>
    <message>
        <source>TCP port</source>
        <translation>TCP ポート</translation>
    </message>
    <message>
        <source>Port for WebSocket and web page</source>
        <translation>WebSocket とウェブページのポート</translation>
    </message>
    <message>
        <source>Port of a web page that shows the targets in a browser. At the same port, programs get the results through a WebSocket</source>
        <translation>ターゲットをブラウザーに表示するウェブページのポート。プログラムは同じポートの WebSocket で結果を受け取れます</translation>
    </message>
    <message>
        <source>WebSocket port</source>
        <translation>WebSocket ポート</translation>
    </message>
    <message>
        <source>OSC to</source>
        <translation>OSC の送信先</translation>
    </message>
    <message>
        <source>Computer and UDP port that OSC messages are sent to, such as 127.0.0.1:9000. Empty: off</source>
        <translation>OSC メッセージを送るコンピューターと UDP ポート（例: 127.0.0.1:9000）。空欄: 無効</translation>
    </message>
    <message>
        <source>TUIO to</source>
        <translation>TUIO の送信先</translation>
    </message>
    <message>
        <source>Computer and UDP port that TUIO 1.1 3D cursors are sent to, such as 127.0.0.1:3333. Empty: off</source>
        <translation>TUIO 1.1 の 3D カーソルを送るコンピューターと UDP ポート（例: 127.0.0.1:3333）。空欄: 無効</translation>
    </message>
    <message>
        <source>CSV file</source>
        <translation>CSV ファイル</translation>
    </message>
    <message>
        <source>File or named pipe that gets one line for each target and frame. Empty: off</source>
        <translation>ターゲットとフレームごとに 1 行を受け取るファイルまたは名前付きパイプ。空欄: 無効</translation>
    </message>
    <message>
        <source>Who can connect</source>
        <translation>接続できる相手</translation>
    </message>
    <message>
        <source>Which computers can connect to the ports. If you allow all computers, anyone in the network can see the results</source>
        <translation>ポートに接続できるコンピューター。すべてのコンピューターを許可すると、ネットワークの誰でも結果を見られます</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Axes of the positions that are sent</source>
        <translation>送信する位置の軸</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Unit of the positions that are sent</source>
        <translation>送信する位置の単位</translation>
    </message>
    <message>
        <source>Max. frames per second</source>
        <translation>1 秒あたりの最大フレーム数</translation>
    </message>
    <message>
        <source>Largest number of frames per second that are sent. 0: all frames</source>
        <translation>1 秒あたりに送信するフレーム数の上限。0: すべて</translation>
    </message>
    <message>
        <source>Token for remote commands</source>
        <translation>リモートコマンドのトークン</translation>
    </message>
    <message>
        <source>Programs that send this word can start and stop the run and the recording of the cameras. At least %1 characters. Empty: commands are ignored</source>
        <translation>この語を送るプログラムは、実行とカメラの録画を開始・停止できます。%1 文字以上。空欄: コマンドを無視します</translation>
    </message>
    <message>
        <source>this computer only</source>
        <translation>このコンピューターのみ</translation>
    </message>
    <message>
        <source>all computers in the network</source>
        <translation>ネットワーク上のすべてのコンピューター</translation>
    </message>
    <message>
        <source>z up, right-handed (as in Dewpoint)</source>
        <translation>z が上、右手系（Dewpoint と同じ）</translation>
    </message>
    <message>
        <source>y up, right-handed</source>
        <translation>y が上、右手系</translation>
    </message>
    <message>
        <source>y up, left-handed (as in Unity)</source>
        <translation>y が上、左手系（Unity と同じ）</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>ミリメートル</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OverlayLegend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>重ね描きの凡例</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ParameterPanel</name>
    <message>
        <source>The parameters appear here once a project is open.</source>
        <translation>プロジェクトを開くと、ここにパラメータが表示されます。</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>手法(&amp;M)</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>どれかのカメラ画像で、物体をクリックするか、枠で囲んでください。</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>This value is larger than “%1”, so %2 is used instead.</source>
        <translation>この値は「%1」より大きいため、代わりに %2 を使います。</translation>
    </message>
    <message>
        <source>Tracking method. Changing it restarts tracking; other settings are kept.</source>
        <translation>追跡の手法。変えると追跡を最初からやり直します。ほかの設定はそのままです。</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>すべて元に戻す</translation>
    </message>
    <message>
        <source>Reset all parameters of this method to their defaults</source>
        <translation>この手法のすべてのパラメータを既定値にします</translation>
    </message>
    <message>
        <source>Volume of interest</source>
        <translation>探索範囲</translation>
    </message>
    <message>
        <source>Targets are searched for only inside a box.</source>
        <translation>ターゲットは箱の中だけで探します。</translation>
    </message>
    <message>
        <source>Some values in this group differ from their defaults.</source>
        <translation>ここに既定値と異なるものがあります。</translation>
    </message>
    <message>
        <source>This value is smaller than “%1”, so “%1” has no effect.</source>
        <translation>この値は「%1」より小さいため、「%1」は効果がありません。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeopleDock</name>
    <message>
        <source>People</source>
        <translation>人物</translation>
    </message>
    <message>
        <source>Click a person in a camera image, or the floor in the bird&apos;s-eye view. Press Esc to cancel.</source>
        <translation>カメラ画像の中の人物、または鳥瞰図の床をクリックしてください。Esc で中止します。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>人物を追加</translation>
    </message>
    <message>
        <source>Remove a person</source>
        <translation>人物を削除</translation>
    </message>
    <message>
        <source>Folder for the 3D shapes of people</source>
        <translation>人物の3D形状を保存するフォルダー</translation>
    </message>
    <message>
        <source>%1 already contains files of an earlier export. Replace them?</source>
        <translation>%1 には以前に書き出したファイルがあります。置き換えますか？</translation>
    </message>
    <message>
        <source>The run has ended, so the 3D shapes of people were not saved.</source>
        <translation>実行が終わっているため、人物の3D形状は保存しませんでした。</translation>
    </message>
    <message>
        <source>Saving the 3D shapes of people…</source>
        <translation>人物の3D形状を保存しています…</translation>
    </message>
    <message>
        <source>Saved the positions, volumes, hulls and densities of the people in %1 (frames: %2).</source>
        <translation>人物の位置、体積、凸包、密度を %1 に保存しました（フレーム数：%2）。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeoplePanel</name>
    <message>
        <source>People in view</source>
        <translation>いまいる人物</translation>
    </message>
    <message>
        <source>Progress of learning the background</source>
        <translation>背景の学習の進み具合</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Position on the floor, x and y in meters</source>
        <translation>床の上の位置、x と y（m）</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>身長</translation>
    </message>
    <message>
        <source>Estimated height in meters; empty if the method does not estimate it</source>
        <translation>推定した身長（m）。この手法で推定しない場合は空欄</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Speed over the floor, in meters per second</source>
        <translation>床の上での秒速（m/s）</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Number of cameras that see the person, out of all cameras</source>
        <translation>その人物が写っているカメラの数 / 全体</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Time since the person entered, in seconds</source>
        <translation>人物が入ってからの時間（秒）</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>近く</translation>
    </message>
    <message>
        <source>Learning the background: %1 %. Keep the scene empty.</source>
        <translation>背景を学習中：%1 %。画面に入らないでください。</translation>
    </message>
    <message>
        <source>Nobody is in view. People appear when two cameras see them.</source>
        <translation>誰もいません。2 台のカメラに写ると人物が現れます。</translation>
    </message>
    <message>
        <source>People in view: %1</source>
        <translation>いまいる人数：%1</translation>
    </message>
    <message>
        <source>People appear here once a method for people runs.</source>
        <translation>人物用の手法を実行すると、ここに人物が現れます。</translation>
    </message>
    <message>
        <source>Another person is close</source>
        <translation>近くに別の人がいます</translation>
    </message>
    <message>
        <source>Number of the person. No other person gets the same number in this run</source>
        <translation>人物の番号。この実行では、ほかの人に同じ番号は使われません</translation>
    </message>
    <message>
        <source>Volume of the hull that encloses 95 % of the person, in cubic meters. Empty unless “Show 3D shapes of people” is on</source>
        <translation>その人物の 95 % を囲む凸包の体積（m³）。「人物の3D形状を表示」がオフの間は空欄</translation>
    </message>
    <message>
        <source>● means that another person is close. Until the two are apart again, the method learns nothing new about the colors of this person</source>
        <translation>● は、近くに別の人がいることを示します。2 人が離れるまで、この人物の色を新たに学習しません</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlanPage</name>
    <message>
        <source>See how accurately these cameras will measure, and where another camera would help. Drag a camera in the bird&apos;s-eye view to update the map.</source>
        <translation>これらのカメラがどれだけ正確に測れるか、もう1台はどこで役立つかが分かります。鳥瞰図でカメラをドラッグするとマップが更新されます。</translation>
    </message>
    <message>
        <source>Map of expected errors</source>
        <translation>予想誤差のマップ</translation>
    </message>
    <message>
        <source>Planned cameras</source>
        <translation>計画中のカメラ</translation>
    </message>
    <message>
        <source>Planned cameras are not saved with the project and take no part in the run. The map does not account for objects that block the view.</source>
        <translation>計画中のカメラはプロジェクトに保存されず、実行にも含まれません。マップは室内の遮蔽物を考慮しません。</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>計画</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerForm</name>
    <message>
        <source>Add planned camera</source>
        <translation>計画用のカメラを追加</translation>
    </message>
    <message>
        <source>Add a planned camera; you can then drag it in the bird&apos;s-eye view, or enter its position (%1)</source>
        <translation>計画中のカメラを追加します。鳥瞰図でドラッグするか、位置を入力できます（%1）</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Remove the planned camera</source>
        <translation>計画中のカメラを削除</translation>
    </message>
    <message>
        <source>Remove the selected planned camera</source>
        <translation>選択した計画中のカメラを取り除く</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>計画中のカメラ</translation>
    </message>
    <message>
        <source>Position x, y, z</source>
        <translation>位置 x, y, z</translation>
    </message>
    <message>
        <source>Looks at x, y, z</source>
        <translation>注視点 x, y, z</translation>
    </message>
    <message>
        <source>Field of view, image width and height</source>
        <translation>画角、画像の幅と高さ</translation>
    </message>
    <message>
        <source>Planned position (%1 coordinate)</source>
        <translation>計画位置（%1 座標）</translation>
    </message>
    <message>
        <source>Position of the camera, in meters</source>
        <translation>カメラの位置（メートル）</translation>
    </message>
    <message>
        <source>Planned camera looks at (%1 coordinate)</source>
        <translation>計画中のカメラの注視点（%1 座標）</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>画角</translation>
    </message>
    <message>
        <source>Horizontal field of view of the camera</source>
        <translation>カメラの水平画角</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>Image height</source>
        <translation>画像の高さ</translation>
    </message>
    <message>
        <source>The search places the camera on four walls and a ceiling at this distance from the volume</source>
        <translation>空間からこの距離にある4つの壁と天井にカメラを置いて探します</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>探索をキャンセル</translation>
    </message>
    <message>
        <source>Stop the search without adding a camera</source>
        <translation>カメラを追加せずに探索を終了します</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>none selected</source>
        <translation>未選択</translation>
    </message>
    <message>
        <source>Find best position for %1</source>
        <translation>%1 の最適な場所を探す</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the position where another camera would help most (%1)</source>
        <translation>もう1台のカメラが最も役立つ場所を壁と天井で探します（%1）</translation>
    </message>
    <message>
        <source>Choose the planned camera whose values are shown below</source>
        <translation>下に値を表示する計画中のカメラを選びます</translation>
    </message>
    <message>
        <source>A point that the planned camera looks at, in meters</source>
        <translation>計画中のカメラが向いている点（メートル）</translation>
    </message>
    <message>
        <source>Width of the planned camera&apos;s image, in pixels</source>
        <translation>計画中のカメラの画像の幅（ピクセル）</translation>
    </message>
    <message>
        <source>Height of the planned camera&apos;s image, in pixels</source>
        <translation>計画中のカメラの画像の高さ（ピクセル）</translation>
    </message>
    <message>
        <source>Distance to walls and ceiling</source>
        <translation>壁と天井までの距離</translation>
    </message>
    <message>
        <source>Distance from the volume to the walls and the ceiling</source>
        <translation>空間から壁と天井までの距離</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerInstaller</name>
    <message>
        <source>Move %1 in the bird&apos;s-eye view</source>
        <translation>鳥瞰図で %1 を移動</translation>
    </message>
    <message>
        <source>Turn %1 in the bird&apos;s-eye view</source>
        <translation>鳥瞰図で %1 を回転</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotPanel</name>
    <message>
        <source>Plots of the run</source>
        <translation>実行のグラフ</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Choose which plots to show; copy or save plots</source>
        <translation>表示するグラフの選択、コピー、保存</translation>
    </message>
    <message>
        <source>Choose which plots to show</source>
        <translation>表示するグラフを選択</translation>
    </message>
    <message>
        <source>The plots are on the clipboard as CSV.</source>
        <translation>グラフを CSV でクリップボードにコピーしました。</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>グラフを保存</translation>
    </message>
    <message>
        <source>Drawings (*.svg);;Pictures (*.png)</source>
        <translation>図面 (*.svg);;画像 (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 を書き込めませんでした。</translation>
    </message>
    <message>
        <source>Plots appear during tracking.</source>
        <translation>追跡を実行すると、グラフが表示されます。</translation>
    </message>
    <message>
        <source>The target whose values are plotted: the target selected in the panel Target, or the first target if none is selected.</source>
        <translation>値をグラフにするターゲット：「ターゲット」パネルで選択したもの、選択していなければ最初のもの。</translation>
    </message>
    <message>
        <source>The frame that all views show. The numbers beside the plots are the values in this frame.
In the plots, the wheel scrolls, Ctrl+wheel zooms in time at the pointer, and Shift+wheel moves along the time axis.</source>
        <translation>すべてのビューが表示しているフレームです。グラフの横の数値はこのフレームのものです。
グラフでは、ホイールでスクロール、Ctrl+ホイールでポインターの位置を中心に時間軸を拡大縮小、Shift+ホイールで時間軸に沿って移動します。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotStack</name>
    <message>
        <source>frame %1, iteration %2, %3</source>
        <translation>フレーム %1、反復 %2、%3</translation>
    </message>
    <message>
        <source>Click: go to this frame · Ctrl+wheel: zoom</source>
        <translation>クリック：このフレームへ · Ctrl+ホイール：拡大縮小</translation>
    </message>
    <message>
        <source>frame %1, %2</source>
        <translation>フレーム %1、%2</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointCalibrator</name>
    <message>
        <source>point %1</source>
        <translation>点 %1</translation>
    </message>
    <message>
        <source>Add measured point</source>
        <translation>測定点を追加</translation>
    </message>
    <message>
        <source>Remove measured point</source>
        <translation>測定点を削除</translation>
    </message>
    <message>
        <source>Rename measured point</source>
        <translation>測定点の名前を変更</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>%1 の位置</translation>
    </message>
    <message>
        <source>Click %1 in %2</source>
        <translation>%2 で %1 をクリック</translation>
    </message>
    <message>
        <source>Remove %1 in %2</source>
        <translation>%2 の %1 を消す</translation>
    </message>
    <message>
        <source>Compute cameras from measured points</source>
        <translation>測定点からカメラを求める</translation>
    </message>
    <message>
        <source>%1: average error %2</source>
        <translation>%1: 平均誤差 %2</translation>
    </message>
    <message>
        <source>%1: no pose fits the clicked points</source>
        <translation>%1: クリックした点に合う姿勢がありません</translation>
    </message>
    <message>
        <source>%1 (ignore this if the camera is mounted that way)</source>
        <translation>%1（カメラをそのように取り付けている場合は無視してください）</translation>
    </message>
    <message>
        <source>%1. After this correction, the average error is %2</source>
        <translation>%1。こう直すと平均誤差は %2 です</translation>
    </message>
    <message>
        <source>%1 does not fit the other points (%2, %3): measure or click it again</source>
        <translation>%1 は他の点と合いません (%2、%3)。測り直すかクリックし直してください</translation>
    </message>
    <message>
        <source>Largest error: %1 (%2, %3)</source>
        <translation>最大のずれ: %1 (%2、%3)</translation>
    </message>
    <message>
        <source>Set orientation of %1</source>
        <translation>%1 の画像の向きを設定</translation>
    </message>
    <message>
        <source>The images of %1 are rotated and mirrored: turn them clockwise by %2 degrees, then mirror them</source>
        <translation>%1 の画像は回転し、鏡像です: 時計回りに %2 度回してから反転してください</translation>
    </message>
    <message>
        <source>The images of %1 are mirrored</source>
        <translation>%1 の画像は鏡像です</translation>
    </message>
    <message>
        <source>The images of %1 are rotated: turn them clockwise by %2 degrees</source>
        <translation>%1 の画像は回転しています: 時計回りに %2 度回してください</translation>
    </message>
    <message>
        <source>%1: the focal length was kept, because computing it needs at least %2 points</source>
        <translation>%1: 焦点距離はそのままです。求めるには少なくとも %2 点が必要です</translation>
    </message>
    <message>
        <source>No point has been clicked yet. Press “Click in images”, then click the selected point in the images</source>
        <translation>まだ点がクリックされていません。「画像でクリック」を押してから、選んだ点を画像でクリックしてください</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n point(s) clicked, but at least %2 are needed (six are better)</source>
        <translation>
            <numerusform>%1: %n 点がクリックされていますが、少なくとも %2 点が必要です（6 点がよりよい）</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: all points lie on one line. Add a point away from this line</source>
        <translation>%1: すべての点が一直線上にあります。この線から外れた点を加えてください</translation>
    </message>
    <message>
        <source>%1: average error %2, but a second pose fits equally well. Add a point outside the plane of the others</source>
        <translation>%1: 平均誤差 %2 ですが、別の姿勢も同じくらい合います。ほかの点がのる平面の外に点を加えてください</translation>
    </message>
    <message>
        <source>Mirror the images of %1</source>
        <translation>%1 の画像を左右反転</translation>
    </message>
    <message>
        <source>Rotate the images of %1 clockwise by %2, and mirror them</source>
        <translation>%1 の画像を時計回りに %2 回転し、左右反転</translation>
    </message>
    <message>
        <source>Rotate the images of %1 clockwise by %2</source>
        <translation>%1 の画像を時計回りに %2 回転</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointsTable</name>
    <message>
        <source>Measured points</source>
        <translation>測定点</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>x m</source>
        <translation>x m</translation>
    </message>
    <message>
        <source>y m</source>
        <translation>y m</translation>
    </message>
    <message>
        <source>z m</source>
        <translation>z m</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>点を追加</translation>
    </message>
    <message>
        <source>Add a position that you measured in the room</source>
        <translation>部屋の中で測った位置を追加します</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>点を削除</translation>
    </message>
    <message>
        <source>Click in images</source>
        <translation>画像でクリック</translation>
    </message>
    <message>
        <source>Remove click</source>
        <translation>クリックを消す</translation>
    </message>
    <message>
        <source>Compute focal lengths</source>
        <translation>焦点距離も求める</translation>
    </message>
    <message>
        <source>Compute cameras</source>
        <translation>カメラを求める</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2、%3</translation>
    </message>
    <message>
        <source>Rotate or mirror the images of this camera and compute its pose again</source>
        <translation>このカメラの画像を回転または反転し、姿勢をもう一度求めます</translation>
    </message>
    <message>
        <source>Click the selected point in every image that shows it. Near a corner, the click moves exactly onto the corner; hold Alt to prevent this. Press Esc to finish.</source>
        <translation>選んだ点を、写っているすべての画像でクリックします。角の近くでは、クリックがちょうど角に移ります。Alt を押していると移りません。Esc で終了します。</translation>
    </message>
    <message>
        <source>Remove the click on the selected point from the image of the selected camera</source>
        <translation>選んだカメラの画像から、選んだ点のクリックを消します</translation>
    </message>
    <message>
        <source>clicked</source>
        <translation>クリック数</translation>
    </message>
    <message>
        <source>Remove the selected point</source>
        <translation>選択した点を削除します</translation>
    </message>
    <message>
        <source>Also compute the focal length of each camera in which you clicked six or more points. Other cameras keep their focal length</source>
        <translation>6 点以上をクリックした各カメラの焦点距離も求めます。ほかのカメラの焦点距離はそのままです</translation>
    </message>
    <message>
        <source>Compute the poses of all cameras in which points were clicked. Each camera needs at least four points; six that do not all lie in one plane are better</source>
        <translation>点をクリックしたすべてのカメラの姿勢を求めます。各カメラに少なくとも 4 点が必要です。一つの平面に並ばない 6 点がよりよい結果になります</translation>
    </message>
    <message>
        <source>Positions measured with a tape, in meters: double-click to edit. ▲ marks a point that does not fit the others.</source>
        <translation>巻尺で測った位置（メートル）。ダブルクリックで編集できます。▲ は他の点と合わない点です。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PreviewPane</name>
    <message>
        <source>Preparing the preview: %1 %</source>
        <translation>プレビューを作成中:%1 %</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>ファイルの先頭行</translation>
    </message>
    <message>
        <source>Units and axes</source>
        <translation>単位と軸</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Some of these results were tracked with earlier settings.</source>
        <translation>この結果の一部は以前の設定によるものです。</translation>
    </message>
    <message>
        <source>The preview was stopped. It starts again when you change a setting.</source>
        <translation>プレビューを止めました。設定を変えると、また始まります。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProblemReport</name>
    <message>
        <source>Report a problem – Dewpoint</source>
        <translation>問題を報告 – Dewpoint</translation>
    </message>
    <message>
        <source>Text for the report</source>
        <translation>報告用のテキスト</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the text so that you can paste it into an email or a form</source>
        <translation>メールやフォームに貼り付けるためにテキストをコピーします</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Run self-test</source>
        <translation>自己診断を実行</translation>
    </message>
    <message>
        <source>Stop the self-test</source>
        <translation>自己診断を中止します</translation>
    </message>
    <message>
        <source>Test graphics, codecs, cameras and disk, and track a simulated scene for a few seconds</source>
        <translation>グラフィックス、コーデック、カメラ、ディスクを調べ、シミュレーションのシーンを数秒間追跡します</translation>
    </message>
    <message>
        <source>Write to whoever gave you Dewpoint. Describe what you did, what you expected and what happened. Run the self-test. Attach the text below and, if you can, the project file and a screenshot. Nothing is sent automatically.</source>
        <translation>Dewpoint の提供元に、何をしたか、何を期待したか、実際に何が起きたかを知らせてください。自己診断を実行し、下のテキストと、できればプロジェクトファイルとスクリーンショットを添えてください。自動で送信されるものはありません。</translation>
    </message>
    <message>
        <source>Progress of the self-test</source>
        <translation>自己診断の進み具合</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectCheckDialog</name>
    <message>
        <source>Checking recordings, times, calibration, colors and method…</source>
        <translation>録画、時刻、キャリブレーション、色、手法をチェックしています…</translation>
    </message>
    <message>
        <source>The check was canceled.</source>
        <translation>チェックを中止しました。</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) must be solved before this project can be tracked.</source>
        <translation>
            <numerusform>このプロジェクトで追跡するには、%n 個の問題を解決する必要があります。</numerusform>
        </translation>
    </message>
    <message>
        <source>No problems, but look at the points marked ◆.</source>
        <translation>問題はありません。◆ の項目は、意図と違うかもしれません。</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>問題はありません。</translation>
    </message>
    <message>
        <source>Check project – Dewpoint</source>
        <translation>プロジェクトをチェック – Dewpoint</translation>
    </message>
    <message>
        <source>Result of the check</source>
        <translation>チェックの結果</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>チェックの進み具合</translation>
    </message>
    <message>
        <source>Read every frame</source>
        <translation>すべてのフレームを読み込む</translation>
    </message>
    <message>
        <source>Find damaged frames anywhere in a recording: all frames are read, not only a few of them. This takes longer</source>
        <translation>録画のどこにある壊れたフレームも見つけます。一部ではなく、すべてのフレームを読みます。時間が長くかかります</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>もう一度チェック</translation>
    </message>
    <message>
        <source>Check the project as it is now</source>
        <translation>今の状態のプロジェクトをチェックします</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>チェックを中止します</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the result as English text, for example for a bug report</source>
        <translation>結果を英語のテキストでコピーします（不具合の報告などに使えます）</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectController</name>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>どれかのカメラ画像で、物体をクリックするか、枠で囲んでください。</translation>
    </message>
    <message>
        <source>Click the object to track in any image. Its color is learned and tracking starts.</source>
        <translation>どの画像でも追跡したい物体をクリックすると、その色を学習して追跡を始めます。</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml);;All files (*)</source>
        <translation>Dewpoint プロジェクト (*.toml);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>The changes were recovered. Save the project to keep them.</source>
        <translation>変更を復元しました。残すにはプロジェクトを保存してください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectPane</name>
    <message>
        <source>Cameras of the project</source>
        <translation>プロジェクトのカメラ</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Exchange with</source>
        <translation>入れ替え</translation>
    </message>
    <message>
        <source>Exchange the image source with that of another camera, for example after the cables were exchanged. The cameras keep their names and calibrations</source>
        <translation>画像ソースを別のカメラと入れ替えます (ケーブルを入れ替えた後など)。名前とキャリブレーションはそのまま残ります</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>表示やファイルで使うカメラの名前</translation>
    </message>
    <message>
        <source>Rotated</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Clockwise rotation of the images before use. The calibration is rotated with them</source>
        <translation>使用前に画像を時計回りに回転します。キャリブレーションも一緒に回転します</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>Mirror the images left to right, after rotation</source>
        <translation>回転したあと、画像を左右に反転します</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>色を固定</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of this camera, and keep the current values</source>
        <translation>このカメラの自動露出、自動ゲイン、自動ホワイトバランスをオフにし、現在の値を保ちます</translation>
    </message>
    <message>
        <source>Lock all cameras</source>
        <translation>すべてのカメラを固定</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of all connected cameras, and keep the current values</source>
        <translation>接続されたすべてのカメラの自動露出、自動ゲイン、自動ホワイトバランスをオフにし、現在の値を保ちます</translation>
    </message>
    <message>
        <source>Remove this camera. Undo restores it with its calibration</source>
        <translation>このカメラを削除します。元に戻すと、キャリブレーションとともに復元されます</translation>
    </message>
    <message>
        <source>A project needs at least one camera</source>
        <translation>プロジェクトには少なくとも 1 台のカメラが必要です</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>A simulated scene has its own cameras. They cannot be changed.</source>
        <translation>シミュレーションのシーンには専用のカメラがあり、変更できません。</translation>
    </message>
    <message>
        <source>▲ Several devices may be this camera. Choose one on the right.</source>
        <translation>▲ このカメラに該当しうるデバイスが複数あります。右側で選んでください。</translation>
    </message>
    <message>
        <source>▲ This device is not connected.</source>
        <translation>▲ このデバイスは接続されていません。</translation>
    </message>
    <message>
        <source>This camera is not calibrated yet.</source>
        <translation>このカメラはまだキャリブレーションされていません。</translation>
    </message>
    <message>
        <source>▲ The calibration is for images of %1. Choose this size, or calibrate again.</source>
        <translation>▲ キャリブレーションは %1 の画像用です。このサイズを選ぶか、キャリブレーションをやり直してください。</translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>トリミング</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::QuickStart</name>
    <message>
        <source>The cameras confirm where the target is.</source>
        <translation>カメラがターゲットの位置を裏付けています。</translation>
    </message>
    <message>
        <source>Another object fits about as well. Press X and drag the target to its true position.</source>
        <translation>別の物体も同じくらい合います。X を押してターゲットを実際の位置へドラッグしてください。</translation>
    </message>
    <message>
        <source>The target is not found yet, or has been out of sight for less than a second.</source>
        <translation>ターゲットがまだ見つかっていないか、見えなくなって 1 秒未満です。</translation>
    </message>
    <message>
        <source>The target has been out of sight for more than a second. The status bar shows why.</source>
        <translation>ターゲットが 1 秒以上見えていません。理由はステータスバーに表示されます。</translation>
    </message>
    <message>
        <source>Quick start – Dewpoint</source>
        <translation>クイックスタート – Dewpoint</translation>
    </message>
    <message>
        <source>What you see</source>
        <translation>見えるもの</translation>
    </message>
    <message>
        <source>Each camera view shows its image with the estimates drawn over it. The bird&apos;s-eye view shows the estimates in the room.</source>
        <translation>各カメラビューは画像と、その上に推定結果を表示します。鳥瞰図は推定結果を部屋の中に表示します。</translation>
    </message>
    <message>
        <source>State of a target</source>
        <translation>ターゲットの状態</translation>
    </message>
    <message>
        <source>How to start</source>
        <translation>始め方</translation>
    </message>
    <message>
        <source>1.  Open one video per camera, or connect cameras: File › New project (%1). Or try the demo first.</source>
        <translation>1.  カメラごとに動画を1つ開くか、カメラを接続します：ファイル › 新しいプロジェクト（%1）。先にデモを試すこともできます。</translation>
    </message>
    <message>
        <source>3.  Click the object to track in any image. Its color is learned in all cameras, and tracking starts.</source>
        <translation>3.  どれかの画像で追跡したい物体をクリックします。すべてのカメラで色が学習され、追跡が始まります。</translation>
    </message>
    <message>
        <source>4.  Press %1 to play or pause. Drag along the timeline to look back: all views then show that frame as it was tracked.</source>
        <translation>4.  %1 を押すと再生または一時停止します。タイムラインをドラッグすると過去を表示できます：すべてのビューがそのフレームを当時のまま表示します。</translation>
    </message>
    <message>
        <source>5.  Export the trajectory: File › Export trajectory (%1).</source>
        <translation>5.  軌跡を書き出します：ファイル › 軌跡を書き出す（%1）。</translation>
    </message>
    <message>
        <source>Show legend…</source>
        <translation>凡例を表示…</translation>
    </message>
    <message>
        <source>Open the legend of everything drawn over the images</source>
        <translation>画像に重ねて描かれるすべての凡例を開きます</translation>
    </message>
    <message>
        <source>Manual…</source>
        <translation>マニュアル…</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>マニュアルを開きます</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
    <message>
        <source>2.  Calibrate the cameras: Calibration › Calibrate (%1) guides you through it. Without a calibration, targets are tracked only in the images.</source>
        <translation>2.  カメラをキャリブレーションします: キャリブレーション › キャリブレーション (%1) が手順を案内します。キャリブレーションがないと、ターゲットは画像内でのみ追跡されます。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentList</name>
    <message>
        <source>The file no longer exists</source>
        <translation>ファイルがなくなっています</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentMenu</name>
    <message>
        <source>No recent projects</source>
        <translation>最近のプロジェクトはありません</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>履歴を消去</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecoveryOffer</name>
    <message>
        <source>Dewpoint closed unexpectedly. Unsaved changes to “%1” from %2 can be recovered.</source>
        <translation>Dewpoint は予期せず終了しました。「%1」の未保存の変更（%2）を復元できます。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復元する</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Unsaved changes to “%1” were discarded.</source>
        <translation>「%1」の未保存の変更を破棄しました。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RigPlanner</name>
    <message>
        <source>With %1 at x %2, y %3, z %4, the error is at most %6 in %5 of the volume (in %7 without this camera).</source>
        <translation>%1 を x %2、y %3、z %4 に置くと、誤差が %6 以内の空間は %5 です。このカメラがなければ %7 だけです。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RoomDisplay</name>
    <message>
        <source>What to show next – Dewpoint</source>
        <translation>次に見せるもの – Dewpoint</translation>
    </message>
    <message>
        <source>Time for which the board was held still</source>
        <translation>ボードを静止させた時間</translation>
    </message>
    <message numerus="yes">
        <source>%n views captured</source>
        <translation>
            <numerusform>%n 個のビューを取得</numerusform>
        </translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>完了。</translation>
    </message>
    <message>
        <source>Press Start on the page Board.</source>
        <translation>「ボード」ページで「開始」を押します。</translation>
    </message>
    <message>
        <source>Waiting for images…</source>
        <translation>画像を待っています…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunAlerts</name>
    <message>
        <source>No camera has moved.</source>
        <translation>動いたカメラはありません。</translation>
    </message>
    <message>
        <source>The pose of %1 cannot be recomputed now.</source>
        <translation>%1 の姿勢は今は計算し直せません。</translation>
    </message>
    <message>
        <source>Recompute pose of %1</source>
        <translation>%1 の姿勢を再計算</translation>
    </message>
    <message>
        <source>The pose of %1 was recomputed. Undo restores the previous pose.</source>
        <translation>%1 の姿勢を計算し直しました。「元に戻す」で以前の姿勢に戻せます。</translation>
    </message>
    <message>
        <source>Disagreement with the other cameras: %1 before, %2 now.</source>
        <translation>他のカメラとのずれ：以前 %1、今 %2。</translation>
    </message>
    <message>
        <source>Done: %1. You can undo this.</source>
        <translation>完了: %1。「元に戻す」で取り消せます。</translation>
    </message>
    <message>
        <source>No longer applies: %1</source>
        <translation>解消: %1</translation>
    </message>
    <message numerus="yes">
        <source>◆ %n notice(s)</source>
        <translation>
            <numerusform>◆ 通知 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the hidden notices</source>
        <translation>隠した通知を表示します</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunDetails</name>
    <message>
        <source>median %1, 99 % at most %2, longest %3</source>
        <translation>中央値 %1、99 % が %2 以内、最長 %3</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>設定なし</translation>
    </message>
    <message>
        <source>%1 (met by %2 % of the iterations of this run)</source>
        <translation>%1（この実行の反復の %2 % が時間内に終了）</translation>
    </message>
    <message>
        <source>Median time per iteration</source>
        <translation>1 反復の時間（中央値）</translation>
    </message>
    <message>
        <source>Time from camera image to estimate</source>
        <translation>カメラ画像から推定までの時間</translation>
    </message>
    <message>
        <source>Time budget per iteration</source>
        <translation>1 反復の時間の上限</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>有効サンプルサイズ</translation>
    </message>
    <message>
        <source>Iterations since the start</source>
        <translation>開始からの反復</translation>
    </message>
    <message>
        <source>Frames skipped</source>
        <translation>飛ばしたフレーム</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>乱数のシード</translation>
    </message>
    <message>
        <source>%1 of %2 particles</source>
        <translation>粒子 %1 / %2</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 / %2 MB</translation>
    </message>
    <message>
        <source>median %1, 99th percentile %2</source>
        <translation>中央値 %1、99 パーセンタイル %2</translation>
    </message>
    <message>
        <source>Median: capture %1 · decode %2 · wait %3 · compute %4 · draw %5</source>
        <translation>中央値: 撮影 %1 · デコード %2 · 待機 %3 · 計算 %4 · 描画 %5</translation>
    </message>
    <message>
        <source>If a camera does not report capture times, the time is counted from the arrival of its image</source>
        <translation>カメラが撮影時刻を報告しない場合、時間は画像の到着から数えます</translation>
    </message>
    <message>
        <source>Time from light to estimate</source>
        <translation>光から推定までの時間</translation>
    </message>
    <message>
        <source>Memory for earlier frames</source>
        <translation>前のフレーム用のメモリ</translation>
    </message>
    <message>
        <source>Memory for going back to earlier frames: images, particles and saved states of the method. When it is full, only the estimates of older frames are kept.</source>
        <translation>前のフレームに戻るためのメモリ: 画像、粒子、手法の保存状態。いっぱいになると、古いフレームは推定値だけが残ります。</translation>
    </message>
    <message>
        <source>99th percentile: capture %1 · decode %2 · wait %3 · compute %4 · draw %5</source>
        <translation>99 パーセンタイル: 撮影 %1 · デコード %2 · 待機 %3 · 計算 %4 · 描画 %5</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SessionController</name>
    <message>
        <source>Restart the run? The results so far will be lost.</source>
        <translation>実行を最初からやり直しますか？これまでの追跡結果は失われます。</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Use image size of the cameras</source>
        <translation>カメラの画像のサイズを取り込む</translation>
    </message>
    <message>
        <source>The recording has ended. Track it again from the beginning? The results so far will be lost.</source>
        <translation>録画の終わりです。最初から追跡し直しますか？これまでの結果は失われます。</translation>
    </message>
    <message>
        <source>Track from the beginning</source>
        <translation>最初から追跡</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>操作を検索</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>説明</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>操作とショートカット</translation>
    </message>
    <message>
        <source>Click here and press the new keys of the chosen action</source>
        <translation>ここをクリックし、選んだ操作の新しいキーを押してください</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>新しいショートカット</translation>
    </message>
    <message>
        <source>No shortcut</source>
        <translation>ショートカットなし</translation>
    </message>
    <message>
        <source>Remove the shortcut of the selected action</source>
        <translation>選んだ操作のショートカットを外します</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>すべて元に戻す</translation>
    </message>
    <message>
        <source>Reset all shortcuts to their defaults</source>
        <translation>すべてのショートカットを既定に戻します</translation>
    </message>
    <message>
        <source>Choose an action, click the field below and press the new keys.</source>
        <translation>操作を選び、下の欄をクリックして新しいキーを押してください。</translation>
    </message>
    <message>
        <source>“%1” no longer has a shortcut.</source>
        <translation>「%1」のショートカットはなくなりました。</translation>
    </message>
    <message>
        <source>All shortcuts were reset to their defaults.</source>
        <translation>すべてのショートカットを既定に戻しました。</translation>
    </message>
    <message>
        <source>“%1” now has the shortcut %2.</source>
        <translation>「%1」のショートカットは %2 になりました。</translation>
    </message>
    <message>
        <source>“%1” now has the shortcut %2, which was removed from “%3”.</source>
        <translation>「%1」のショートカットは %2 になり、「%3」からは外れました。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; changed shortcuts are already saved</source>
        <translation>閉じる（変更したショートカットは保存済み）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SourcePane</name>
    <message>
        <source>Connected to this computer</source>
        <translation>このコンピューターに接続済み</translation>
    </message>
    <message>
        <source>No camera is connected. Plug one in: it appears here by itself.</source>
        <translation>カメラが接続されていません。接続すると自動的にここに表示されます。</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Assign to selected camera</source>
        <translation>選択したカメラに割り当て</translation>
    </message>
    <message>
        <source>Network cameras, pipelines and test patterns</source>
        <translation>ネットワークカメラ、パイプライン、テストパターン</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>動画を追加…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>画像フォルダーを追加…</translation>
    </message>
    <message>
        <source>A simulated scene has its own cameras. They cannot be changed.</source>
        <translation>シミュレーションのシーンには専用のカメラがあり、変更できません。</translation>
    </message>
    <message>
        <source>This project has live cameras. Recordings need a project of their own.</source>
        <translation>このプロジェクトにはライブカメラがあります。録画には別のプロジェクトが必要です。</translation>
    </message>
    <message>
        <source>This project has recordings. Live cameras need a project of their own.</source>
        <translation>このプロジェクトには録画があります。ライブカメラには別のプロジェクトが必要です。</translation>
    </message>
    <message>
        <source>used by %1</source>
        <translation>%1 が使用中</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>The project uses this device already</source>
        <translation>プロジェクトはこのデバイスをすでに使用しています</translation>
    </message>
    <message>
        <source>Add the device as a new camera of the project</source>
        <translation>デバイスをプロジェクトの新しいカメラとして追加します</translation>
    </message>
    <message>
        <source>Exchange the devices of this camera and of the selected camera</source>
        <translation>このカメラと選択したカメラのデバイスを入れ替えます</translation>
    </message>
    <message>
        <source>Make this device the image source of the selected camera. The camera keeps its name and its calibration</source>
        <translation>このデバイスを選択したカメラの画像ソースにします。カメラの名前とキャリブレーションは変わりません</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>動画ファイル（カメラごとに1つ）</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>フレームごとに1枚の画像が入ったフォルダー</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>カメラごとに動画を選択</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>動画 (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>画像フォルダーを選択</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SpeedButton</name>
    <message>
        <source>1/%1 ×</source>
        <comment>speed</comment>
        <translation>1/%1 倍</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <comment>speed</comment>
        <translation>%1 倍</translation>
    </message>
    <message>
        <source>Playback speed of the recording. Live cameras are always tracked in real time.</source>
        <translation>録画の再生速度。ライブカメラは常にリアルタイムで追跡します。</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>再生速度</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StartPage</name>
    <message>
        <source>Dewpoint</source>
        <translation>Dewpoint</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>デモを試す</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>最近のプロジェクト</translation>
    </message>
    <message>
        <source>You can also drop a project or videos onto this window.</source>
        <translation>プロジェクトや動画をこのウィンドウにドロップすることもできます。</translation>
    </message>
    <message>
        <source>Watch the filter converge</source>
        <translation>フィルターの収束を見る</translation>
    </message>
    <message>
        <source>A cloud of guesses slides along a line of sight and snaps onto the ball.</source>
        <translation>推測の雲が視線に沿って滑り、ボールにぴたりと集まります。</translation>
    </message>
    <message>
        <source>Hidden for a second</source>
        <translation>1 秒間隠れる</translation>
    </message>
    <message>
        <source>People in an office</source>
        <translation>オフィスの人々</translation>
    </message>
    <message>
        <source>Four cameras find everyone in 3D and give each person a number.</source>
        <translation>4 台のカメラが全員を 3D で見つけ、それぞれに番号を付けます。</translation>
    </message>
    <message>
        <source>One camera, target in a box</source>
        <translation>カメラ 1 台、枠の中のターゲット</translation>
    </message>
    <message>
        <source>Needs no calibration: the target is marked with a rectangle and tracked by its colors.</source>
        <translation>キャリブレーション不要：ターゲットを枠で示し、色で追跡します。</translation>
    </message>
    <message>
        <source>Calibrate by hand</source>
        <translation>手動でキャリブレーション</translation>
    </message>
    <message>
        <source>Drag a grid over the images until it matches the floor.</source>
        <translation>画像の上で格子を床に重なるまでドラッグします。</translation>
    </message>
    <message>
        <source>Follow colored objects in 3D with ordinary cameras.</source>
        <translation>普通のカメラで、色の付いた物体を 3D で追跡します。</translation>
    </message>
    <message>
        <source>Two simulated cameras see a pink ball; a particle filter finds it and follows it through space. Pause, go back, change anything: you cannot break it.</source>
        <translation>2 台のシミュレーションのカメラがピンクのボールを見ています。粒子フィルターがそれを見つけ、空間を追跡します。一時停止しても、過去を表示しても、何を変えても、壊れることはありません。</translation>
    </message>
    <message>
        <source>Your own data</source>
        <translation>自分のデータ</translation>
    </message>
    <message>
        <source>Open videos…</source>
        <translation>動画を開く…</translation>
    </message>
    <message>
        <source>One recording per camera</source>
        <translation>カメラごとに録画 1 つ</translation>
    </message>
    <message>
        <source>Use cameras…</source>
        <translation>カメラを使う…</translation>
    </message>
    <message>
        <source>Connected cameras or network streams</source>
        <translation>接続されたカメラ、またはネットワーク映像</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>プロジェクトを開く…</translation>
    </message>
    <message>
        <source>A project saved earlier</source>
        <translation>以前に保存したプロジェクト</translation>
    </message>
    <message>
        <source>A box passes in front of the ball. One camera is enough to keep tracking the ball.</source>
        <translation>箱がボールの前を横切ります。カメラ 1 台だけでボールの追跡を保てます。</translation>
    </message>
    <message>
        <source>Calibrate cameras…</source>
        <translation>カメラをキャリブレーション…</translation>
    </message>
    <message>
        <source>From videos of a board or a ball, step by step</source>
        <translation>ボードまたはボールの映像から、手順に沿って</translation>
    </message>
    <message>
        <source>Identical balls</source>
        <translation>同じ色のボール</translation>
    </message>
    <message>
        <source>Other balls have the same color, but only one ball moves.</source>
        <translation>同じ色のボールがほかにもありますが、動くのは1つだけです。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StatusBarPanel</name>
    <message>
        <source>playing</source>
        <translation>再生中</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>一時停止中</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Estimated position of the target in the room</source>
        <translation>部屋の中でのターゲットの推定位置</translation>
    </message>
    <message>
        <source>frame %1 / %2</source>
        <translation>フレーム %1 / %2</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>フレーム %1</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3</source>
        <translation>x %1  y %2  z %3</translation>
    </message>
    <message>
        <source>tracking again</source>
        <translation>再追跡中</translation>
    </message>
    <message>
        <source>looking back</source>
        <translation>過去を表示中</translation>
    </message>
    <message>
        <source>State of the run: playing, paused, at the end, looking back at an earlier frame, or tracking again</source>
        <translation>実行の状態：再生中、一時停止、終端、過去のフレームを表示中、または再追跡中</translation>
    </message>
    <message>
        <source>the box shows the expected position</source>
        <translation>枠は予測位置を示しています</translation>
    </message>
    <message>
        <source>click the object or drag a box around it</source>
        <translation>物体をクリックするか、枠で囲む</translation>
    </message>
    <message>
        <source>x %1  y %2  %3 × %4</source>
        <translation>x %1  y %2  %3 × %4</translation>
    </message>
    <message>
        <source>● people: %1</source>
        <translation>● 人物：%1</translation>
    </message>
    <message>
        <source>○ people: %1, searching</source>
        <translation>○ 人物：%1、探索中</translation>
    </message>
    <message>
        <source>other objects fit equally well: press X and drag the target to its position</source>
        <translation>別の物体も同じくらい合います：X を押し、ターゲットをその位置へドラッグ</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>Speed of the target in the room</source>
        <translation>部屋の中でのターゲットの速さ</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Timing, particles and memory used</source>
        <translation>時間、粒子、使用メモリ</translation>
    </message>
    <message>
        <source>Tracking: the cameras confirm the estimate. Ambiguous: another object fits about as well. Lost: not tracked for more than a second.</source>
        <translation>追跡中：カメラが推定を裏付けています。あいまい：別の物体も同じくらい合います。見失い：1 秒以上追跡できていません。</translation>
    </message>
    <message>
        <source>Uncertainty of the position: the standard deviations in x, y and z combined. The plots show each of the three</source>
        <translation>位置の不確かさ：x、y、z の標準偏差を合わせたもの。グラフには 3 つがそれぞれ表示されます</translation>
    </message>
    <message>
        <source>Number of the frame shown, and number of all frames. Click to go to another frame</source>
        <translation>表示中のフレームの番号と、全フレーム数。クリックすると別のフレームへ移動できます</translation>
    </message>
    <message>
        <source>Frames tracked per second, while playing</source>
        <translation>再生中に 1 秒あたりに追跡したフレーム数</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StepStrip</name>
    <message>
        <source>Step %1: %2</source>
        <translation>ステップ %1: %2</translation>
    </message>
    <message>
        <source>Step %1: %2. %3</source>
        <translation>ステップ %1: %2。%3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeComparison</name>
    <message>
        <source>This take contains the results of the live run.</source>
        <translation>このテイクにはライブ実行の結果が含まれています。</translation>
    </message>
    <message>
        <source>Compare results</source>
        <translation>結果を比較</translation>
    </message>
    <message>
        <source>Tracking the take again…</source>
        <translation>テイクをもう一度追跡しています…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeController</name>
    <message>
        <source>The recording ended, because its cameras were closed.</source>
        <translation>カメラが閉じられたため、録画を終了しました。</translation>
    </message>
    <message>
        <source>Take %1 (%2) was saved in %3.</source>
        <translation>テイク %1（%2）を %3 に保存しました。</translation>
    </message>
    <message>
        <source>Problem: %1</source>
        <translation>問題: %1</translation>
    </message>
    <message>
        <source>Open take</source>
        <translation>テイクを開く</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>フォルダーを表示</translation>
    </message>
    <message>
        <source>Notes…</source>
        <translation>メモ…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeDialog</name>
    <message>
        <source>Take %1</source>
        <translation>テイク %1</translation>
    </message>
    <message>
        <source>Next take</source>
        <translation>次のテイク</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>next free number</source>
        <translation>次の空き番号</translation>
    </message>
    <message>
        <source>Number of the take and of its folder. The number increases by itself with each take.</source>
        <translation>テイクとそのフォルダーの番号です。番号はテイクごとに自動的に増えます。</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Pre-roll</source>
        <translation>プリロール</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How many seconds before the start are recorded as well. For this, the last images of all cameras are kept in memory, up to 512 MB in total.</source>
        <translation>開始前のこの時間も録画されます。そのために全カメラの最新の画像を、合計 512 MB までメモリに保持します。</translation>
    </message>
    <message>
        <source>Text that is saved with the take</source>
        <translation>テイクと一緒に保存されるテキスト</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetPanel</name>
    <message>
        <source>Targets</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Target name, as shown in views and files</source>
        <translation>表示やファイルで使うターゲットの名前</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Radius of the ball, 0 to 2,000 mm. If unknown, it is estimated.</source>
        <translation>ボールの半径、0〜2,000 mm。不明の場合は推定します。</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>ボール</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>No target yet. In any camera image, click the object to track.</source>
        <translation>ターゲットはまだありません。カメラ画像で追跡したい物体をクリックしてください。</translation>
    </message>
    <message>
        <source>Rename target</source>
        <translation>ターゲットの名前を変更</translation>
    </message>
    <message>
        <source>Change radius</source>
        <translation>半径を変更</translation>
    </message>
    <message>
        <source>Change shape</source>
        <translation>形状を変更</translation>
    </message>
    <message>
        <source>Remove target</source>
        <translation>ターゲットを取り除く</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view. It is tracked from there.</source>
        <translation>どれかのカメラ画像で、物体をクリックするか、枠で囲んでください。そこから追跡します。</translation>
    </message>
    <message>
        <source>No box in this frame.</source>
        <translation>このフレームには枠がありません。</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>半径 %1</translation>
    </message>
    <message>
        <source>radius %1 (estimated)</source>
        <translation>半径 %1（推定）</translation>
    </message>
    <message>
        <source>radius unknown</source>
        <translation>半径不明</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Add target</source>
        <translation>ターゲットを追加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>枠</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>学習</translation>
    </message>
    <message>
        <source>Ball: the outline of the target is a circle in every image. Any: the size of the target is learned, and its position is the center of the region that has its color. Automatic: the shape is determined from the images. Only method dewpoint uses this setting.</source>
        <translation>ボール: どの画像でもターゲットの輪郭は円です。任意: ターゲットの大きさを学習し、その色の領域の中心を位置とします。自動: 形を画像から判断します。手法 dewpoint だけがこの設定を使います。</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>半径 (mm)</translation>
    </message>
    <message>
        <source>To learn the color of this target, press Learn and click the target in a camera image.</source>
        <translation>このターゲットの色を学習するには、「学習」を押してカメラ画像のターゲットをクリックします。</translation>
    </message>
    <message>
        <source>Hide target</source>
        <translation>ターゲットを隠す</translation>
    </message>
    <message>
        <source>Show target</source>
        <translation>ターゲットを表示</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetRowDelegate</name>
    <message>
        <source>Hide this target in the images and in the bird&apos;s-eye view. It is still tracked.</source>
        <translation>このターゲットを画像と鳥瞰図で隠します。追跡は続きます。</translation>
    </message>
    <message>
        <source>Show this target in the images and in the bird&apos;s-eye view</source>
        <translation>このターゲットを画像と鳥瞰図に表示します</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ThreadCountDialog</name>
    <message>
        <source>Filter threads</source>
        <translation>フィルターのスレッド数</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>スレッド数</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Number of threads that compute the filter. The results do not depend on it</source>
        <translation>フィルターを計算するスレッドの数。結果は変わりません</translation>
    </message>
    <message>
        <source>The new number is used from the next frame on.</source>
        <translation>新しい数は次のフレームから使われます。</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Use this number</source>
        <translation>この数にする</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Close and keep the current number</source>
        <translation>今の数のまま閉じる</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Timeline</name>
    <message>
        <source>Nothing tracked yet: press play (Space), then drag here to move through time.</source>
        <translation>まだ追跡していません: 再生 (スペース) してから、ここをドラッグして時間を移動します。</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>The change applies to new frames. Use “%1” to track again from the current frame.</source>
        <translation>変更は新しいフレームに適用されます。「%1」で現在のフレームから追跡し直せます。</translation>
    </message>
    <message>
        <source>After this frame, there are no new problems with targets or cameras.</source>
        <translation>このフレームより後に、ターゲットやカメラの新しいトラブルはありません。</translation>
    </message>
    <message>
        <source>Before this frame, there are no other problems with targets or cameras.</source>
        <translation>このフレームより前に、ターゲットやカメラのほかのトラブルはありません。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TouchedInstantList</name>
    <message>
        <source>What the ball does at this time</source>
        <translation>この時刻のボールの状態</translation>
    </message>
    <message>
        <source>Add current time</source>
        <translation>現在の時刻を追加</translation>
    </message>
    <message>
        <source>Remove time</source>
        <translation>時刻を削除</translation>
    </message>
    <message>
        <source>Remove the selected time from the list</source>
        <translation>選んだ時刻を一覧から削除します</translation>
    </message>
    <message>
        <source>Added times</source>
        <translation>追加した時刻</translation>
    </message>
    <message>
        <source>Double-click or press Enter to show the images of this time</source>
        <translation>ダブルクリックまたは Enter でその時刻の画像を表示</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The upward direction is computed from three positions at which the ball touches the floor, or from a fall of the ball</source>
        <translation>上の向きは、ボールが床に触れた 3 か所、またはボールの落下から求めます</translation>
    </message>
    <message>
        <source>Add the time of the images shown to the list. In these images, the ball must do what you selected</source>
        <translation>表示中の画像の時刻を一覧に追加します。この画像で、ボールが選択したとおりの状態にある必要があります</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryModel</name>
    <message>
        <source>time, s</source>
        <translation>時間, s</translation>
    </message>
    <message>
        <source>Time of the frame, in seconds</source>
        <translation>フレームの時刻（秒）</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>1 から数えたフレーム番号</translation>
    </message>
    <message>
        <source>target</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>ターゲットの名前</translation>
    </message>
    <message>
        <source>%1, m</source>
        <translation>%1, m</translation>
    </message>
    <message>
        <source>Position in the room, in meters</source>
        <translation>室内での位置（メートル）</translation>
    </message>
    <message>
        <source>σ%1, mm</source>
        <translation>σ%1, mm</translation>
    </message>
    <message>
        <source>Standard deviation of the position, in millimeters</source>
        <translation>位置の標準偏差（ミリメートル）</translation>
    </message>
    <message>
        <source>speed, m/s</source>
        <translation>速さ, m/s</translation>
    </message>
    <message>
        <source>Speed in meters per second, computed from five frames</source>
        <translation>速さ（メートル毎秒）。5 フレームから計算します</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>existence</source>
        <translation>存在確率</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>◆ corrected</source>
        <translation>◆ 修正済み</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ あいまい</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● 追跡中</translation>
    </message>
    <message>
        <source>○ not tracked</source>
        <translation>○ 未追跡</translation>
    </message>
    <message>
        <source>Tracking: the cameras confirm the estimate. Ambiguous: another object fits about as well. Corrected: you set the position</source>
        <translation>追跡中：カメラが推定を裏付けています。あいまい：別の物体も同じくらい合います。修正済み：位置をあなたが指定しました</translation>
    </message>
    <message>
        <source>Number of cameras that see the target</source>
        <translation>ターゲットが見えているカメラの数</translation>
    </message>
    <message>
        <source>Existence probability: how likely it is that the target is there and tracked, 0 to 1</source>
        <translation>存在確率：ターゲットがそこにあって追跡されている確率（0〜1）</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryPanel</name>
    <message>
        <source>Trajectory</source>
        <translation>軌跡</translation>
    </message>
    <message>
        <source>Speed and height over time</source>
        <translation>時間に対する速さと高さ</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message numerus="yes">
        <source>%n rows are on the clipboard as CSV.</source>
        <translation>
            <numerusform>%n 行を CSV としてクリップボードにコピーしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The trajectory appears here as soon as the target is tracked.</source>
        <translation>ターゲットの追跡が始まると、ここに軌跡が表示されます。</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n サンプル</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples, no gaps</source>
        <translation>
            <numerusform>%n サンプル、欠落なし</numerusform>
        </translation>
    </message>
    <message>
        <source>The boxes are on the clipboard as CSV.</source>
        <translation>枠を CSV としてクリップボードにコピーしました。</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>修正を取り消す</translation>
    </message>
    <message>
        <source>Speed and height appear during tracking.</source>
        <translation>追跡を実行すると、速さと高さが表示されます。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::UncertaintyMapForm</name>
    <message>
        <source>Show the map in the bird&apos;s-eye view</source>
        <translation>鳥瞰図にマップを表示</translation>
    </message>
    <message>
        <source>Show the position error to expect for a target at each point. The map changes whenever a camera moves</source>
        <translation>各点で予想されるターゲットの位置誤差を表示します。マップはカメラの動きに追従します</translation>
    </message>
    <message>
        <source>Colors show</source>
        <translation>色の意味</translation>
    </message>
    <message>
        <source>the expected error</source>
        <translation>予想誤差</translation>
    </message>
    <message>
        <source>the number of cameras</source>
        <translation>カメラの数</translation>
    </message>
    <message>
        <source>Meaning of the colors</source>
        <translation>色が示すもの</translation>
    </message>
    <message>
        <source>The expected error (standard deviation in the worst direction), or the number of cameras that see a point</source>
        <translation>予想誤差（最も悪い方向の標準偏差）、またはその点が見えるカメラの数</translation>
    </message>
    <message>
        <source>Acceptable error</source>
        <translation>許容誤差</translation>
    </message>
    <message>
        <source>Errors up to this value are blue in the map. The summary and the search for a camera position also use this value</source>
        <translation>この値までの誤差はマップで青になります。要約とカメラ位置の探索にも使われます</translation>
    </message>
    <message>
        <source>Detection error</source>
        <translation>検出誤差</translation>
    </message>
    <message>
        <source>Error of a target&apos;s position in an image, in pixels (one standard deviation)</source>
        <translation>画像内のターゲットの位置の誤差（ピクセル、標準偏差）</translation>
    </message>
    <message>
        <source>Layer at</source>
        <translation>層の高さ</translation>
    </message>
    <message>
        <source>Show the map in a horizontal layer</source>
        <translation>水平な層にマップを表示</translation>
    </message>
    <message>
        <source>Height of the layer above the floor</source>
        <translation>床からの層の高さ</translation>
    </message>
    <message>
        <source>Surfaces around good and fair regions</source>
        <translation>良い範囲とまずまずの範囲を囲む面</translation>
    </message>
    <message>
        <source>Volume: minimum x, y, z</source>
        <translation>空間の最小値 x, y, z</translation>
    </message>
    <message>
        <source>Volume: maximum x, y, z</source>
        <translation>空間の最大値 x, y, z</translation>
    </message>
    <message>
        <source>Minimum %1 of the map&apos;s volume</source>
        <translation>マップの空間の %1 の最小値</translation>
    </message>
    <message>
        <source>Maximum %1 of the map&apos;s volume</source>
        <translation>マップの空間の %1 の最大値</translation>
    </message>
    <message>
        <source>Set from reference grid</source>
        <translation>基準格子に合わせる</translation>
    </message>
    <message>
        <source>Use the volume above the reference grid, up to the highest camera</source>
        <translation>基準格子の上、最も高いカメラまでの空間を使います</translation>
    </message>
    <message>
        <source>Height of the layer above the floor, in meters</source>
        <translation>床からのレイヤーの高さ（メートル）</translation>
    </message>
    <message>
        <source>Show surfaces in the room. For the error: around the regions with at most 0.4, 1 and 2 times the acceptable error. For the number of cameras: around the regions that two, three and four cameras see</source>
        <translation>部屋に面を表示します。誤差の場合：許容誤差の 0.4 倍、1 倍、2 倍以下の範囲を囲みます。カメラの数の場合：2 台、3 台、4 台のカメラから見える範囲を囲みます</translation>
    </message>
    <message>
        <source>Smallest x, y and z of the volume, in meters</source>
        <translation>空間の x、y、z の最小値（メートル）</translation>
    </message>
    <message>
        <source>Largest x, y and z of the volume, in meters</source>
        <translation>空間の x、y、z の最大値（メートル）</translation>
    </message>
    <message>
        <source>The error is at most %2 in %1 of the volume. Fewer than two cameras see %3 of the volume</source>
        <translation>誤差が %2 以内の空間は %1 です。見えるカメラが 2 台未満の空間は %3 です</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoDialog</name>
    <message>
        <source>Export video</source>
        <translation>動画を書き出す</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>書き出すファイル</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>参照…</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>書き出すファイルを選びます</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop the export. No file is written</source>
        <translation>書き出しを中止します。ファイルは残りません</translation>
    </message>
    <message>
        <source>Write the video in the background</source>
        <translation>動画をバックグラウンドで書き出します</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; a running export continues</source>
        <translation>閉じます。実行中の書き出しは続きます</translation>
    </message>
    <message>
        <source>Saved the video %1.</source>
        <translation>動画 %1 を保存しました。</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>書き出しはキャンセルされました。</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 はすでにあります。何も書き出されませんでした。</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>no view is checked</source>
        <translation>チェックされた表示がありません</translation>
    </message>
    <message>
        <source>Images: %1. Length: %2. Size: %3 × %4 pixels.</source>
        <translation>画像: %1 枚。長さ: %2。サイズ: %3 × %4 ピクセル。</translation>
    </message>
    <message>
        <source>This computer draws the bird&apos;s-eye view slowly. It is drawn in a smaller size and enlarged.</source>
        <translation>このコンピューターでは鳥瞰図の描画に時間がかかります。小さく描いて拡大します。</translation>
    </message>
    <message>
        <source>This computer has no encoder for videos.</source>
        <translation>このコンピューターには動画のエンコーダーがありません。</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 はすでにあります。置き換えますか?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>The export was stopped because the run has ended.</source>
        <translation>実行が終わったため、書き出しを中止しました。</translation>
    </message>
    <message>
        <source>The export was stopped because the run was restarted.</source>
        <translation>実行が最初からやり直されたため、書き出しを中止しました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoForm</name>
    <message>
        <source>camera images</source>
        <translation>カメラ画像</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>pixels</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>MP4 (H.264)</source>
        <translation>MP4 (H.264)</translation>
    </message>
    <message>
        <source>WebM (VP8)</source>
        <translation>WebM (VP8)</translation>
    </message>
    <message>
        <source>AVI (Motion JPEG)</source>
        <translation>AVI (Motion JPEG)</translation>
    </message>
    <message>
        <source>Matroska (FFV1, lossless)</source>
        <translation>Matroska (FFV1、可逆)</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>The checked views are shown side by side</source>
        <translation>チェックした表示を並べて示します</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Time in the recording at which the video begins, 0 to 1,000,000 s</source>
        <translation>動画の始まりとなる記録内の時刻、0~1,000,000 s</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Time in the recording at which the video ends, 0 to 1,000,000 s. The end is the last tracked frame; later frames have no results</source>
        <translation>動画の終わりとなる記録内の時刻、0~1,000,000 s。「終わり」は追跡済みの最後のフレームです。それより後のフレームに結果はありません</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed of the video, up to 100: 1 is real time, 0.1 is ten times slower, and 8 is eight times faster. With 0, every frame is shown once</source>
        <translation>動画の速さ（最大 100）: 1 は実時間、0.1 は 10 分の 1、8 は 8 倍の速さです。0 では各フレームを 1 回ずつ示します</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Width and height of the video in pixels</source>
        <translation>動画の幅と高さ(ピクセル)</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>フレームレート</translation>
    </message>
    <message>
        <source>Images of the video per second, 1 to 240</source>
        <translation>動画の 1 秒あたりの画像数、1~240</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Formats that this computer can write</source>
        <translation>このコンピューターで書き出せる形式</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>最初</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>終わり</translation>
    </message>
    <message>
        <source>show every frame once</source>
        <translation>各フレームを 1 回表示</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>録画のとおり</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> /秒</translation>
    </message>
    <message>
        <source>Titles of the views</source>
        <translation>表示の名前</translation>
    </message>
    <message>
        <source>Write the name of each view into its corner</source>
        <translation>各表示の名前を隅に書きます</translation>
    </message>
    <message>
        <source>Frame and time</source>
        <translation>フレームと時刻</translation>
    </message>
    <message>
        <source>Write the name of the recording, the frame number and the time into the video</source>
        <translation>録画の名前、フレーム番号、時刻を動画に書きます</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoPreview</name>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Choose the image of the video that the preview shows</source>
        <translation>プレビューに表示する動画の画像を選びます</translation>
    </message>
    <message>
        <source>Image %1 of %2: frame %3</source>
        <translation>画像 %1 / %2：フレーム %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewButtons</name>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>View from above: X to the right, Y up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>上から見る：X は右、Y は上。ドラッグで移動、ホイールで拡大縮小、ダブルクリックで全体を表示。</translation>
    </message>
    <message>
        <source>View from the front: X to the right, Z up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>正面から見る：X は右、Z は上。ドラッグで移動、ホイールで拡大縮小、ダブルクリックで全体を表示。</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>Fit everything in the view without changing the viewing direction (or double-click)</source>
        <translation>視線の向きを変えずに全体を表示します（ダブルクリックでも可）。</translation>
    </message>
    <message>
        <source>Perspective view. Drag to orbit, Shift-drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>透視図。ドラッグで回転、Shift を押しながらドラッグで移動、ホイールで拡大縮小、ダブルクリックで全体を表示。</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側面</translation>
    </message>
    <message>
        <source>View from the side: Y to the right, Z up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>側面から見る：Y は右、Z は上。ドラッグで移動、ホイールで拡大縮小、ダブルクリックで全体を表示。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewPictures</name>
    <message>
        <source>Save picture as PNG…</source>
        <translation>画像を PNG で保存…</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>画像をコピー</translation>
    </message>
    <message>
        <source>Save a picture of %1</source>
        <translation>%1 の画像を保存</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Saved the picture %1.</source>
        <translation>画像 %1 を保存しました。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VolumeForm</name>
    <message>
        <source>Minimum X, Y, Z</source>
        <translation>最小値 X, Y, Z</translation>
    </message>
    <message>
        <source>Maximum X, Y, Z</source>
        <translation>最大値 X, Y, Z</translation>
    </message>
    <message>
        <source>Minimum %1 of the volume of interest</source>
        <translation>探索範囲の %1 の最小値</translation>
    </message>
    <message>
        <source>Maximum %1 of the volume of interest</source>
        <translation>探索範囲の %1 の最大値</translation>
    </message>
    <message>
        <source>Compute from cameras</source>
        <translation>カメラから</translation>
    </message>
    <message>
        <source>Search for targets in the box around the region that at least two cameras see</source>
        <translation>少なくとも二台のカメラに写る範囲を囲む箱の中でターゲットを探します</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Search for targets anywhere</source>
        <translation>ターゲットをあらゆる場所で探します</translation>
    </message>
    <message>
        <source>Set volume of interest</source>
        <translation>探索範囲を設定</translation>
    </message>
    <message>
        <source>Remove volume of interest</source>
        <translation>探索範囲を解除</translation>
    </message>
    <message>
        <source>Targets are searched for only inside this box.</source>
        <translation>ターゲットはこの箱の中だけで探します。</translation>
    </message>
    <message>
        <source>None: targets are searched for everywhere. The numbers show the region that the cameras see; change one of them to search in a box.</source>
        <translation>なし：ターゲットはあらゆる場所で探します。数値はカメラに写る範囲です。変更すると箱の中で探します。</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. Change a number to search in a box.</source>
        <translation>なし：ターゲットはあらゆる場所で探します。数値を変更すると箱の中で探します。</translation>
    </message>
    <message>
        <source>Change volume of interest</source>
        <translation>探索範囲を変更</translation>
    </message>
    <message>
        <source>Smallest x, y and z of the volume of interest, in meters. Targets are searched for only inside this box</source>
        <translation>探索範囲の x、y、z の最小値（メートル）。ターゲットはこの直方体の中だけで探します</translation>
    </message>
    <message>
        <source>Largest x, y and z of the volume of interest, in meters. Targets are searched for only inside this box</source>
        <translation>探索範囲の x、y、z の最大値（メートル）。ターゲットはこの直方体の中だけで探します</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrationPage</name>
    <message>
        <source>Align the cameras by hand until they are roughly right. Then wave the ball, or a wand with two balls, through the whole volume, and press Refine cameras.</source>
        <translation>まず手作業でカメラをおおよそ合わせます。次にボール、または 2 つのボールの付いたワンドを空間全体で振り、「カメラを精密化」を押します。</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>Wand</source>
        <translation>ワンド</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>精密化</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Align the cameras by hand until they are roughly right. Then refine them with a recording in which you wave a ball, or a wand with two balls, through the whole volume.</source>
        <translation>まず手作業でカメラをおおよそ合わせます。次に、ボール、または2つのボールの付いたワンドを空間全体で振った録画を使って精密化します。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrator</name>
    <message>
        <source>Press “Start waving”, then wave for half a minute in the volume in which you want to track.</source>
        <translation>「振り始める」を押し、追跡したい空間で30秒ほど振ってください。</translation>
    </message>
    <message>
        <source>Refine cameras with a wand</source>
        <translation>ワンドでカメラを精密化</translation>
    </message>
    <message>
        <source>Refine cameras with a ball</source>
        <translation>ボールでカメラを精密化</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandForm</name>
    <message>
        <source>the ball&apos;s diameter</source>
        <translation>ボールの直径</translation>
    </message>
    <message>
        <source>the ball&apos;s diameter, %1</source>
        <translation>ボールの直径 %1</translation>
    </message>
    <message>
        <source>the current camera positions</source>
        <translation>現在のカメラ位置</translation>
    </message>
    <message>
        <source>a known distance</source>
        <translation>既知の距離</translation>
    </message>
    <message>
        <source>Wand</source>
        <translation>ワンド</translation>
    </message>
    <message>
        <source>one ball</source>
        <translation>1つのボール</translation>
    </message>
    <message>
        <source>wand with two balls</source>
        <translation>2つのボールの付いたワンド</translation>
    </message>
    <message>
        <source>Kind of wand</source>
        <translation>ワンドの種類</translation>
    </message>
    <message>
        <source>A wand with two balls also gives the scale. This scale is more accurate than one from a diameter or a distance</source>
        <translation>2 つのボールの付いたワンドからは縮尺も求まります。直径や距離から求めるより正確です</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>ボール</translation>
    </message>
    <message>
        <source>The target that you wave; it is detected by its color</source>
        <translation>振るターゲット。色で検出します</translation>
    </message>
    <message>
        <source>Second ball</source>
        <translation>2つ目のボール</translation>
    </message>
    <message>
        <source>The target at the other end of the wand</source>
        <translation>ワンドのもう一方の端のターゲット</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Length of the wand</source>
        <translation>ワンドの長さ</translation>
    </message>
    <message>
        <source>Distance from the center of one ball to the center of the other</source>
        <translation>一方のボールの中心からもう一方の中心までの距離</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Scale from</source>
        <translation>縮尺の基準</translation>
    </message>
    <message>
        <source>Source of the scale</source>
        <translation>縮尺の求め方</translation>
    </message>
    <message>
        <source>Images alone cannot show whether a room is large or small. A scale from the diameter of a ball is accurate to about one percent. A scale from a distance is as accurate as your measurement</source>
        <translation>画像だけでは部屋が大きいか小さいか分かりません。ボールの直径から求めた縮尺の精度は約 1 パーセントです。距離から求めた縮尺の精度は、その測定の精度と同じです</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Known distance</source>
        <translation>既知の距離</translation>
    </message>
    <message>
        <source>Distance between the two positions at which the center of the ball was held</source>
        <translation>ボールの中心を置いた2か所の間の距離</translation>
    </message>
    <message>
        <source>Initial error</source>
        <translation>初期誤差</translation>
    </message>
    <message>
        <source>Expected error of the initial positions</source>
        <translation>初期位置の予想誤差</translation>
    </message>
    <message>
        <source>Roughly how far each camera may be from its true position</source>
        <translation>各カメラの真の位置からのおおよその距離</translation>
    </message>
    <message>
        <source>Expected error of the initial rotations</source>
        <translation>初期回転の予想誤差</translation>
    </message>
    <message>
        <source>Roughly how far each camera may be rotated from its true orientation</source>
        <translation>各カメラの真の向きからのおおよその角度</translation>
    </message>
    <message>
        <source>Find delays</source>
        <translation>遅れを求める</translation>
    </message>
    <message>
        <source>Find focal lengths</source>
        <translation>焦点距離を求める</translation>
    </message>
    <message>
        <source>Also compute the focal length of each camera. Use this for lenses that were never calibrated, or whose zoom has changed</source>
        <translation>各カメラの焦点距離も計算します。キャリブレーションしたことのないレンズや、ズームが変わったレンズに使います</translation>
    </message>
    <message>
        <source>Find the distortion k1</source>
        <translation>歪み k1 を求める</translation>
    </message>
    <message>
        <source>Also compute the first distortion coefficient of each lens. For this, the ball must be seen up to the edges of the images</source>
        <translation>各レンズの第 1 歪み係数も計算します。それには、画像の端までボールが写っている必要があります</translation>
    </message>
    <message>
        <source>Only the selected time span</source>
        <translation>選択した時間の区間だけ</translation>
    </message>
    <message>
        <source>Use only the part of the recording that is selected in the timeline</source>
        <translation>録画のうち、タイムラインで選択した部分だけを使います</translation>
    </message>
    <message>
        <source>Also compute the delay of each camera. Use this if the cameras do not take their images at the same time</source>
        <translation>各カメラの遅れも計算します。カメラが同時に撮影しない場合に使います</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandOutcome</name>
    <message>
        <source>Refine cameras</source>
        <translation>カメラを精密化</translation>
    </message>
    <message>
        <source>Detect the ball in all images and compute the cameras that fit best</source>
        <translation>すべての画像でボールを検出し、最もよく合うカメラを計算します</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop and keep the cameras unchanged</source>
        <translation>中止し、カメラをそのままにします</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>前の状態</translation>
    </message>
    <message>
        <source>Use calibration anyway</source>
        <translation>それでもキャリブレーションを使う</translation>
    </message>
    <message>
        <source>Use this calibration although it looks wrong; you can undo this</source>
        <translation>問題がありそうでも、このキャリブレーションを使います。元に戻せます</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>レポートを保存…</translation>
    </message>
    <message>
        <source>Refined cameras</source>
        <translation>精密化したカメラ</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>moved cm</source>
        <translation>移動 cm</translation>
    </message>
    <message>
        <source>rotated °</source>
        <translation>回転 °</translation>
    </message>
    <message>
        <source>delay ms</source>
        <translation>遅れ ms</translation>
    </message>
    <message>
        <source>Reprojection error: root mean square distance between detected and projected balls</source>
        <translation>再投影誤差：検出と投影のボールの距離の二乗平均平方根</translation>
    </message>
    <message>
        <source>Distance between the old and the new position of the camera</source>
        <translation>カメラの元の位置と新しい位置の距離</translation>
    </message>
    <message>
        <source>Angle between the old and the new orientation of the camera</source>
        <translation>カメラの元の向きと新しい向きの角度</translation>
    </message>
    <message>
        <source>The cameras are unchanged.</source>
        <translation>カメラは変わっていません。</translation>
    </message>
    <message>
        <source>The fall gives a gravity of %1 m/s² (9.81 is expected).</source>
        <translation>落下から求めた重力は %1 m/s² です（期待値は 9.81）。</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>レポートを保存</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>ウェブページ (*.html)</translation>
    </message>
    <message>
        <source>Results for each camera; hover over a heading to see its meaning</source>
        <translation>各カメラの結果。見出しを指すと意味が表示されます</translation>
    </message>
    <message>
        <source>The cameras have changed since this refinement.</source>
        <translation>この精密化の後にカメラが変更されています。</translation>
    </message>
    <message>
        <source>Additional delay of this camera&apos;s images relative to the first camera</source>
        <translation>最初のカメラに対する、このカメラの画像の追加の遅れ</translation>
    </message>
    <message>
        <source>Camera delays are saved in the project and used to synchronize images from now on.</source>
        <translation>カメラの遅れはプロジェクトに保存され、以後の画像の同期に使われます。</translation>
    </message>
    <message>
        <source>Hold down this button to draw the grid with the calibration from before this refinement</source>
        <translation>このボタンを押している間、この精密化の前のキャリブレーションで格子を描きます</translation>
    </message>
    <message>
        <source>Save a page with all numbers, the residuals as arrows, the coverage and a 3D drawing</source>
        <translation>すべての数値、残差の矢印、網羅範囲、3D の図を含むページを保存します</translation>
    </message>
    <message>
        <source>The result is less accurate than the initial camera positions: you entered that their error is at most %1. Wave through more of the volume.</source>
        <translation>結果は初期のカメラ位置より不正確です。初期位置の誤差は最大 %1 と入力されています。空間のより広い範囲で振ってください。</translation>
    </message>
    <message>
        <source>Calibrations from different parts of the recording differ from each other %1 times as much as image noise can explain. The stated accuracy takes this into account.</source>
        <translation>録画の各部分から求めたキャリブレーションのばらつきは、画像の雑音から予想される大きさの %1 倍です。示された精度にはそれが含まれています。</translation>
    </message>
    <message>
        <source>%1 was far off: the refinement rotates this camera by %2 and moves it by %3, much more than the other cameras. Was it moved after its calibration?</source>
        <translation>%1は大きくずれていました。補正でこのカメラを%2回転し、%3移動します。ほかのカメラよりはるかに大きな値です。キャリブレーションの後に動かしませんでしたか?</translation>
    </message>
    <message>
        <source>The previous calibration fits the images as well as the new one. Keep the previous one, or wave longer and through more of the volume.</source>
        <translation>以前のキャリブレーションも、新しいものと同じ程度に画像に合っています。以前のものを使うか、より長く、空間のより広い範囲で振ってください。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandWaving</name>
    <message>
        <source>Collect positions of the ball from all camera images. If you start again, the positions collected before are discarded</source>
        <translation>すべてのカメラの画像からボールの位置を集めます。始め直すと、前に集めた位置は破棄されます</translation>
    </message>
    <message>
        <source>■ Stop waving</source>
        <translation>■ 振り終える</translation>
    </message>
    <message>
        <source>● Start waving</source>
        <translation>● 振り始める</translation>
    </message>
    <message>
        <source>Stop waving</source>
        <translation>振り終える</translation>
    </message>
    <message>
        <source>Start waving</source>
        <translation>振り始める</translation>
    </message>
    <message>
        <source>No ball positions collected yet.</source>
        <translation>ボールの位置はまだ集められていません。</translation>
    </message>
    <message>
        <source>Every camera has seen the ball often enough: stop waving, or press Refine cameras.</source>
        <translation>どのカメラもボールを十分に見ました。振り終えるか、「カメラを精密化」を押してください。</translation>
    </message>
    <message>
        <source>Frames skipped because they arrived too fast: %1.</source>
        <translation>速すぎたため飛ばしたフレーム: %1。</translation>
    </message>
    <message>
        <source>The positions of the ball have been recorded for %1 so far.</source>
        <translation>これまでに %1間、ボールの位置を記録しました。</translation>
    </message>
    <message>
        <source>Keep waving: each camera should see the ball at least 150 times, spread over at least half of its image.</source>
        <translation>振り続けてください。各カメラがボールを少なくとも150回、画像の少なくとも半分にわたって見る必要があります。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WindowMenus</name>
    <message>
        <source>Cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Choose this camera</source>
        <translation>このカメラを選びます</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>Choose this target</source>
        <translation>このターゲットを選びます</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>キャリブレーション(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>実行(&amp;R)</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>最近のプロジェクトを開く</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>表示パネル</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Show this view</source>
        <translation>このビューを表示します</translation>
    </message>
    <message>
        <source>Switch to this language</source>
        <translation>この言語に切り替えます</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>システムに合わせる</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldMarkTool</name>
    <message>
        <source>Click point %1 in two images · Esc: stop</source>
        <translation>点 %1 を 2 つの画像でクリック · Esc:終了</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter marks the point there</source>
        <translation>%1 の画像:矢印キーで十字を動かし、Enter でそこに点をマークします</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldMarks</name>
    <message>
        <source>Turn the world upright</source>
        <translation>世界座標系を正立させる</translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation>床を設定</translation>
    </message>
    <message>
        <source>Make a line level</source>
        <translation>線を水平にする</translation>
    </message>
    <message>
        <source>Set the origin</source>
        <translation>原点を設定</translation>
    </message>
    <message>
        <source>Set the x axis</source>
        <translation>x 軸を設定</translation>
    </message>
    <message>
        <source>Set a distance</source>
        <translation>距離を設定</translation>
    </message>
    <message>
        <source>A, B and C lie on one line. Mark points that are spread over the floor.</source>
        <translation>A、B、C が一直線上にあります。床に広がった点をマークしてください。</translation>
    </message>
    <message>
        <source>The floor is set: A is the origin, and the x axis points to B. The world was rotated by %1.</source>
        <translation>床を設定しました。A が原点で、x 軸は B を向きます。世界座標系を %1 回転しました。</translation>
    </message>
    <message>
        <source>All lengths were multiplied by %1.</source>
        <translation>すべての長さを %1 倍しました。</translation>
    </message>
    <message>
        <source>A is now the origin.</source>
        <translation>A が原点です。</translation>
    </message>
    <message>
        <source>The world was rotated by %1.</source>
        <translation>世界座標系を %1 回転しました。</translation>
    </message>
    <message>
        <source>Rotate all cameras</source>
        <translation>すべてのカメラを回転</translation>
    </message>
    <message>
        <source>Move all cameras</source>
        <translation>すべてのカメラを移動</translation>
    </message>
    <message>
        <source>Check a distance</source>
        <translation>距離を確認</translation>
    </message>
    <message>
        <source>The line from A to B is far from horizontal.</source>
        <translation>A から B への線は水平からかけ離れています。</translation>
    </message>
    <message>
        <source>A is directly above or below B, so the x axis cannot point from A to B.</source>
        <translation>A は B の真上または真下にあるため、x 軸を A から B に向けることはできません。</translation>
    </message>
    <message>
        <source>From A to B, the calibration gives %1; you measured %2. The calibration is off by %3 %.</source>
        <translation>A から B まで、キャリブレーションの値は %1、計測値は %2 です。キャリブレーションの誤差は %3 % です。</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldPage</name>
    <message>
        <source>Floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>⚠ The z axis does not seem to point up.</source>
        <translation>⚠ z 軸が上を向いていないようです。</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>x m</source>
        <translation>x m</translation>
    </message>
    <message>
        <source>y m</source>
        <translation>y m</translation>
    </message>
    <message>
        <source>z m</source>
        <translation>z m</translation>
    </message>
    <message>
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
    <message>
        <source>Points of the room that you mark in the images, and their positions. ± is one standard deviation of a position, if clicks are accurate to 2 px.</source>
        <translation>画像でマークする室内の点とその位置。± は、クリックの精度を 2 px とした位置の標準偏差です。</translation>
    </message>
    <message>
        <source>Remove marks</source>
        <translation>マークを削除</translation>
    </message>
    <message>
        <source>Remove the marks of A, B and C from all images</source>
        <translation>すべての画像から A、B、C のマークを削除します</translation>
    </message>
    <message>
        <source>Floor, origin and scale</source>
        <translation>床、原点、縮尺</translation>
    </message>
    <message>
        <source>Measured distance from A to B</source>
        <translation>測定した A から B までの距離</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>The distance that you measured in the room, in meters</source>
        <translation>室内で測定した距離(メートル)</translation>
    </message>
    <message>
        <source>Turn upright</source>
        <translation>正立させる</translation>
    </message>
    <message>
        <source>Set floor from A, B and C</source>
        <translation>A、B、C から床を設定</translation>
    </message>
    <message>
        <source>The floor goes through A, B and C. A becomes the origin, and the x axis points to B.</source>
        <translation>床は A、B、C を通ります。A が原点になり、x 軸は B を向きます。</translation>
    </message>
    <message>
        <source>Make line A–B level</source>
        <translation>線 A–B を水平にする</translation>
    </message>
    <message>
        <source>Rotate the world by the smallest angle that makes this line horizontal</source>
        <translation>この線が水平になる最小の角度だけ世界座標系を回転します</translation>
    </message>
    <message>
        <source>Origin at A</source>
        <translation>A を原点にする</translation>
    </message>
    <message>
        <source>Move the origin to A; the axes keep their directions</source>
        <translation>原点を A に移します。軸の向きは変わりません</translation>
    </message>
    <message>
        <source>x axis along A–B</source>
        <translation>x 軸を A–B に沿わせる</translation>
    </message>
    <message>
        <source>Rotate the world about the vertical until the x axis points from A to B</source>
        <translation>x 軸が A から B を向くまで、世界座標系を鉛直軸のまわりに回転します</translation>
    </message>
    <message>
        <source>Set scale</source>
        <translation>縮尺を設定</translation>
    </message>
    <message>
        <source>Multiply all lengths by one factor, so that the distance from A to B is the measured one</source>
        <translation>A から B までの距離が測定値になるように、すべての長さに同じ係数を掛けます</translation>
    </message>
    <message>
        <source>Move all cameras together</source>
        <translation>すべてのカメラをまとめて移動</translation>
    </message>
    <message>
        <source>Shift of all cameras along %1</source>
        <translation>%1 方向へのすべてのカメラの移動量</translation>
    </message>
    <message>
        <source>How far all cameras move along %1, in meters</source>
        <translation>すべてのカメラを %1 方向に動かす距離(メートル)</translation>
    </message>
    <message>
        <source>Quarter turn about %1</source>
        <translation>%1 軸まわりに 90° 回転</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Rotation of all cameras about the vertical axis</source>
        <translation>鉛直軸まわりのすべてのカメラの回転</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Rotate and move all cameras together</source>
        <translation>すべてのカメラをまとめて回転・移動します</translation>
    </message>
    <message>
        <source>Quarter turn</source>
        <translation>90° 回転</translation>
    </message>
    <message>
        <source>A: origin</source>
        <translation>A:原点</translation>
    </message>
    <message>
        <source>B: on the x axis</source>
        <translation>B:x 軸上</translation>
    </message>
    <message>
        <source>C: on the floor</source>
        <translation>C:床の上</translation>
    </message>
    <message>
        <source>Mark in images</source>
        <translation>画像でマーク</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>Set the floor, the origin and the scale of the room. The cameras keep their positions relative to each other.</source>
        <translation>部屋の床、原点、縮尺を設定します。カメラどうしの位置関係は変わりません。</translation>
    </message>
    <message>
        <source>Compare the distance from A to B in the calibration with the distance that you measured. Nothing is changed.</source>
        <translation>キャリブレーションでの A から B までの距離を、計測した距離と比べます。何も変わりません。</translation>
    </message>
    <message>
        <source>Set floor from the board shown</source>
        <translation>表示中のボードから床を設定</translation>
    </message>
    <message>
        <source>Use a board that lies flat on the floor in the images shown. Its first corner becomes the origin, and the x axis runs along its rows. Describe the board on the page Board.</source>
        <translation>表示中の画像で床に平らに置かれたボードを使います。ボードの最初の角が原点になり、x 軸は行に沿います。ボードは「ボード」ページで指定してください。</translation>
    </message>
    <message>
        <source>Rotate the world by quarter turns until its upward direction points up in the images</source>
        <translation>上向きが画像でも上になるまで、世界座標系を 90° 単位で回転します</translation>
    </message>
    <message>
        <source>Rotate all cameras by 90° about the %1 axis, counterclockwise if the axis points toward you</source>
        <translation>すべてのカメラを %1 軸のまわりに 90° 回転します(軸が手前を向くとき反時計回り)</translation>
    </message>
    <message>
        <source>Angle by which all cameras rotate about the vertical through the origin, counterclockwise as seen from above. The cameras are rotated first and then moved</source>
        <translation>原点を通る鉛直軸のまわりにすべてのカメラを回転する角度（上から見て反時計回り）。回転してから移動します</translation>
    </message>
    <message>
        <source>Click the selected point in two or more images. Near a corner, the click moves exactly onto the corner; hold Alt to prevent this. Press Esc to finish.</source>
        <translation>選択した点を 2 つ以上の画像でクリックします。角の近くでは、クリックがちょうど角に移ります。Alt を押していると移りません。Esc で終了します。</translation>
    </message>
    <message>
        <source>marked</source>
        <translation>マーク数</translation>
    </message>
</context>
</TS>
