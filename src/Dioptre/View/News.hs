-- |
-- Module      : Dioptre.View.News
-- Description : What a page does not know yet
--
-- Each page has been told something of the desk, and is told the rest when it is ready for it. Nothing waits in a
-- queue: what a slow page misses in between it never hears of, and what it is told is as new as can be. So a page that
-- reads slowly, or not at all, costs neither memory nor anybody's time.
module Dioptre.View.News
  ( Told,
    nothing,
    News (..),
    news,
  )
where

import Data.Foldable (toList)
import qualified Data.Sequence as Seq
import Dioptre.Render.Row (planWidth)
import Dioptre.Source.Language (Language)
import Dioptre.View.Desk
import Dioptre.View.Frame
import Dioptre.View.Message (Message (..))

-- | What a page has been told.
data Told = Told
  { -- | Version, whether it is saved, and whether it is in conflict.
    toldScene :: !(Maybe (Int, Bool, Bool)),
    -- | Of which version, and after how many changes of other files, what is wrong with it, in which language.
    toldFaults :: !(Maybe (Int, Int, Bool, Language)),
    -- | Which picture.
    toldFrame :: !(Maybe Int),
    -- | How many of its strips.
    toldStrips :: !Int,
    -- | That it is finished.
    toldDone :: !Bool,
    -- | The language.
    toldLanguage :: !Language
  }

-- | What a page has been told that has only been greeted.
nothing :: Language -> Told
nothing = Told Nothing Nothing Nothing 0 False

-- | A piece of news: a message, or strips of a picture, which are all coarse or all fine.
data News
  = Say Message
  | Show Frame Bool [Int]

-- | What a page is to be told, given what it has been told, the desk, and how far the desk's picture is; and what it
-- has been told then. Of a picture no more strips than make about a megabyte.
--
-- Law: who has been told everything is told nothing.
news :: Told -> Desk -> Maybe (Frame, Progress) -> ([News], Told)
news told desk picture = (concat [language, scene, faults, gone, begins, strips, painting, done], told')
  where
    language = [Say (Speaks (deskLanguage desk)) | deskLanguage desk /= toldLanguage told]
    sceneNow = (deskVersion desk, isSaved desk, deskConflict desk)
    scene = [Say (SceneIs (deskVersion desk) (deskBy desk) (isSaved desk) (deskConflict desk) (deskText desk)) | Just sceneNow /= toldScene told]
    faultsNow = (\c -> (checkedVersion c, checkedChanges c, checkedDrawn c, deskLanguage desk)) <$> deskChecked desk
    faults = [Say (Found (deskLanguage desk) c) | faultsNow /= toldFaults told, Just c <- [deskChecked desk]]
    frameNow = frameNumber . fst <$> picture
    isNew = frameNow /= toldFrame told
    gone = [Say (Abandoned n) | isNew, not (toldDone told), Just n <- [toldFrame told]]
    begins = [Say (Start frame) | isNew, Just (frame, _) <- [picture]]
    from = if isNew then 0 else toldStrips told
    (strips, upTo) = case picture of
      Nothing -> ([], 0)
      Just (frame, progress) ->
        let batch = Seq.take (max 8 (megabyte `div` (4 * planWidth (framePlan frame)))) (Seq.drop from (progressStrips progress))
            coarse = [k | Coarse k <- toList batch]
            fine = [y | Fine y <- toList batch]
         in ([Show frame False coarse | not (null coarse)] <> [Show frame True fine | not (null fine)], from + Seq.length batch)
    painting = [Say (Painting frame progress) | upTo > from, Just (frame, progress) <- [picture]]
    isDone = case picture of
      Just (_, progress) -> progressEnd progress == Finished && upTo == Seq.length (progressStrips progress)
      Nothing -> False
    done = [Say (Done frame progress) | isDone, isNew || not (toldDone told), Just (frame, progress) <- [picture]]
    told' = Told (Just sceneNow) faultsNow frameNow upTo isDone (deskLanguage desk)

-- | So many bytes are sent at once.
megabyte :: Int
megabyte = 1024 * 1024
